package brickless.viewer;

import brickless.trace.PageParts;
import java.util.List;
import java.util.stream.Stream;

/**
 * The page of the live view: the parts of the report and its own joined into one text that loads nothing.
 *
 * <p>It finds the server by relative addresses ({@code events}, {@code do}, {@code stimuli}), so it must be served
 * below an address that ends in a slash. Its content policy lets only its own script run and lets it talk to its own
 * server only.
 */
final class LivePage {
    /** Styles in the order they are joined. */
    private static final List<String> STYLES = paths(List.of("theme.css", "layout.css", "brick.css", "tracks.css"),
            List.of("live.css", "hands.css"));
    /** Scripts in the order they are joined: those behind may use those before. */
    private static final List<String> SCRIPTS = paths(
            List.of("recording.js", "sensors.js", "screen.js", "behaviours.js", "dom.js", "widgets.js", "drawing.js",
                    "arena.js", "brick.js", "tracks.js", "plots.js",
                    "timeline.js", "listing.js", "events.js", "figures.js"),
            List.of("live-recording.js", "link.js", "hold.js", "sensing.js", "live-arena.js", "handle.js", "hands.js",
                    "live-brick.js", "loudspeaker.js", "live-tracks.js",
                    "live-lists.js", "tools.js", "controls.js", "notices.js", "live.js"));

    private LivePage() {}

    private static List<String> paths(List<String> ofReport, List<String> own) {
        return Stream.concat(ofReport.stream().map("report/"::concat), own.stream().map("viewer/"::concat)).toList();
    }

    /** The whole page. */
    static String html() {
        String script = PageParts.script(SCRIPTS);
        return PageParts.text("viewer/page.html").replace("%SCRIPT_HASH%", PageParts.hash(script))
                .replace("%STYLE%", PageParts.joined(STYLES)).replace("%SCRIPT%", script);
    }
}
