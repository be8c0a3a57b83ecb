package brickless.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** How a page gets into the browser, with a stand-in for the command that opens it. */
class BrowserWindowTest {
    private static final URI PAGE = URI.create("file:///runs/one%20run/report.html");

    @TempDir Path folder;

    /** Puts an {@code xdg-open} into the folder that writes down what it is to open and ends with a status. */
    private void opener(int status) throws IOException {
        Path script = folder.resolve("xdg-open");
        Files.writeString(script, "#!/bin/sh\nprintf '%s' \"$1\" >'" + folder.resolve("opened") + "'\nexit " + status + "\n");
        assertThat(script.toFile().setExecutable(true)).isTrue();
    }

    private boolean show(String variable) {
        return new BrowserWindow(Map.of("PATH", "/nowhere:" + folder, variable, ":0"), "Linux").show(PAGE);
    }

    @Test void thePageIsOpenedWhereThereIsAScreen() throws IOException {
        opener(0);
        assertThat(show("DISPLAY")).isTrue();
        assertThat(folder.resolve("opened")).hasContent(PAGE.toString());
        Files.delete(folder.resolve("opened"));
        assertThat(show("WAYLAND_DISPLAY")).isTrue();
        assertThat(folder.resolve("opened")).exists();
    }

    @Test void withoutAScreenNothingIsOpened() throws IOException {
        opener(0);
        assertThat(show("OTHER")).isFalse();
        assertThat(folder.resolve("opened")).doesNotExist();
    }

    @Test void withoutABrowserNothingIsOpened() throws IOException {
        assertThat(show("DISPLAY")).as("no xdg-open").isFalse();
        opener(3);
        assertThat(show("DISPLAY")).as("xdg-open found no browser").isFalse();
    }
}
