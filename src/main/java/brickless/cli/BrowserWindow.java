package brickless.cli;

import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** Shows pages in the user's browser, by the command that the operating system has for it: no window system is needed in this JVM. */
final class BrowserWindow {
    /** A command that is still busy then has found its browser. */
    private static final long PATIENCE_SECONDS = 3;

    private final Map<String, String> environment;
    private final String system;

    /**
     * Creates a window.
     *
     * @param environment variables of the process
     * @param system name of the operating system
     */
    BrowserWindow(Map<String, String> environment, String system) {
        this.environment = environment;
        this.system = system.toLowerCase(Locale.ROOT);
    }

    /** Shows a page; false on a machine without a screen or a browser. */
    boolean show(URI page) {
        List<String> command = new ArrayList<>(opener());
        if (command.isEmpty()) {
            return false;
        }
        command.add(page.toString());
        try {
            Process process = new ProcessBuilder(command).redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .redirectError(ProcessBuilder.Redirect.DISCARD).start();
            return !process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS) || process.exitValue() == 0;
        } catch (IOException e) {
            return false;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    private List<String> opener() {
        if (system.contains("win")) {
            return List.of("rundll32", "url.dll,FileProtocolHandler");
        }
        if (system.contains("mac")) {
            return List.of("open");
        }
        boolean screen = !environment.getOrDefault("DISPLAY", "").isEmpty() || !environment.getOrDefault("WAYLAND_DISPLAY", "").isEmpty();
        return screen ? onPath("xdg-open") : List.of();
    }

    private List<String> onPath(String name) {
        for (String folder : environment.getOrDefault("PATH", "").split(File.pathSeparator)) {
            Path program = Path.of(folder, name);
            if (Files.isExecutable(program)) {
                return List.of(program.toString());
            }
        }
        return List.of();
    }
}
