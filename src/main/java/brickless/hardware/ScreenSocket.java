package brickless.hardware;

/** The screen: 178 × 128 pixels, one bit each, made of layers that are shown on top of each other (combined by OR). */
public interface ScreenSocket {
    /** Width in pixels. */
    int WIDTH = 178;
    /** Height in pixels. */
    int HEIGHT = 128;
    /** Bytes per row; the lowest bit is the leftmost pixel. */
    int ROW_BYTES = (WIDTH + 7) / 8;

    /**
     * Adds a layer, or finds it again by name. New layers are visible and refresh themselves.
     *
     * @return the layer's live memory, {@code ROW_BYTES × HEIGHT} bytes, row by row, 1 = black; drawing is writing to
     *     it
     */
    byte[] layer(String name);

    /** Shows or hides a layer. */
    void setVisible(String name, boolean visible);

    /** Whether the layer takes part in the automatic copy to the screen every 250 ms. */
    void setAutoRefresh(String name, boolean automatic);

    /** Copies all visible layers to the screen now. */
    void refresh();

    /**
     * Tells that the program has drawn into a layer; charges the processor time that the drawing takes on the brick.
     *
     * @param pixels pixels looked at or written; block copies count one per byte
     */
    void drawn(int pixels);

    /** A copy of what the screen shows, {@code ROW_BYTES × HEIGHT} bytes. */
    byte[] displayed();
}
