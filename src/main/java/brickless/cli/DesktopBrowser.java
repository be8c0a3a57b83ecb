package brickless.cli;

import java.io.IOException;
import java.net.URI;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** The browser of the person at this machine. */
final class DesktopBrowser {
    private DesktopBrowser() {}

    /** Shows a page, if there is a screen and a browser; the program that opens it runs on by itself. */
    static boolean show(URI address) {
        Optional<List<String>> opener = opener(System.getProperty("os.name").toLowerCase(Locale.ROOT),
                System.getenv("DISPLAY") != null || System.getenv("WAYLAND_DISPLAY") != null);
        try {
            if (opener.isEmpty()) {
                return false;
            }
            ProcessBuilder command = new ProcessBuilder(
                    Stream.concat(opener.get().stream(), Stream.of(address.toString())).toList());
            command.redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    /** What opens addresses on an operating system; empty on one without a screen. */
    static Optional<List<String>> opener(String system, boolean screen) {
        if (system.startsWith("mac")) {
            return Optional.of(List.of("open"));
        }
        if (system.startsWith("windows")) {
            return Optional.of(List.of("rundll32", "url.dll,FileProtocolHandler"));
        }
        return screen ? Optional.of(List.of("xdg-open")) : Optional.empty();
    }
}
