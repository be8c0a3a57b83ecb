package brickless.viewer;

/** The page of the live view. */
final class LivePage {
    private LivePage() {}

    /** The page as HTML with its styles and scripts inside. */
    static String html() {
        return "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Brickless</title><p>Live view</p></html>\n";
    }
}
