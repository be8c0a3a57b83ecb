package brickless.trace;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Puts a report together: one HTML file with style, scripts and the whole run inside, which needs no network.
 *
 * <p>Everything that comes from the program travels compressed in base64, so nothing it prints can be taken for markup;
 * the page's content policy lets only its own script run and loads nothing from anywhere.
 */
public final class HtmlReport {
    private static final String FOLDER = "report/";
    /** Styles in the order they are joined. */
    private static final List<String> STYLES = List.of("theme.css", "layout.css", "brick.css", "tracks.css");
    /** Parts of the page in the order they are joined: those behind may use those before. */
    private static final List<String> SCRIPTS = List.of("inflate.js", "recording.js", "sensors.js", "screen.js",
            "behaviours.js", "player.js", "dom.js", "widgets.js", "drawing.js", "arena.js", "brick.js", "tracks.js",
            "plots.js", "timeline.js", "listing.js", "events.js", "figures.js", "transport.js", "main.js");

    private HtmlReport() {}

    /**
     * Writes the report of a run.
     *
     * @param out where to; not closed
     * @param recording the whole run
     * @param scene what to draw it with
     * @param summary the JSON object of the run's figures, if there is one
     */
    public static void write(OutputStream out, ReportRecording recording, ReportScene scene, Optional<String> summary)
            throws IOException {
        String script = PageParts.script(SCRIPTS.stream().map(FOLDER::concat).toList());
        String page = PageParts.text(FOLDER + "page.html").replace("%TITLE%", PageParts.escaped(recording.main()))
                .replace("%SCRIPT_HASH%", PageParts.hash(script));
        int style = page.indexOf("%STYLE%");
        int data = page.indexOf("%DATA%");
        int code = page.indexOf("%SCRIPT%");
        text(out, page.substring(0, style));
        text(out, PageParts.joined(STYLES.stream().map(FOLDER::concat).toList()));
        text(out, page.substring(style + "%STYLE%".length(), data));
        data(out, recording, scene, summary);
        text(out, page.substring(data + "%DATA%".length(), code));
        text(out, script);
        text(out, page.substring(code + "%SCRIPT%".length()));
    }

    private static void data(OutputStream out, ReportRecording recording, ReportScene scene, Optional<String> summary)
            throws IOException {
        Deflater packer = new Deflater();
        try (OutputStream packed = new DeflaterOutputStream(Base64.getEncoder().wrap(new Unclosed(out)),
                packer, 1 << 16)) {
            JsonText.object(packed, line -> {
                line.raw("summary", summary.map(String::strip).orElse("null"));
                line.object("scene", () -> scene.write(line));
                recording.write(line);
            });
        } finally {
            packer.end();
        }
    }

    private static void text(OutputStream out, String text) throws IOException {
        out.write(text.getBytes(StandardCharsets.UTF_8));
    }

    /** Lets a stream around another one be closed alone. */
    private static final class Unclosed extends java.io.FilterOutputStream {
        Unclosed(OutputStream out) {
            super(out);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
            out.write(bytes, offset, length);
        }

        @Override
        public void close() throws IOException {
            flush();
        }
    }
}
