package lejos.hardware.video;

import java.io.IOException;

/** A camera. */
public interface Video {
    /** Pixel format: motion JPEG. */
    int PIX_FMT_MJPEG = VideoUtils.fourcc('M', 'J', 'P', 'G');
    /** Pixel format: JPEG. */
    int PIX_FMT_JPEG = VideoUtils.fourcc('J', 'P', 'E', 'G');
    /** Pixel format: YUYV 4:2:2. */
    int PIX_FMT_YUYV = VideoUtils.fourcc('Y', 'U', 'Y', 'V');
    /** Field order: any. */
    int FIELD_ANY = 0;
    /** Field order: none. */
    int FIELD_NONE = 1;
    /** Field order: interlaced. */
    int FIELD_INTERLACED = 4;

    /**
     * Opens the camera.
     *
     * @param w width in pixels
     * @param h height in pixels
     * @param format one of the {@code PIX_FMT_} constants
     * @param field one of the {@code FIELD_} constants
     * @param fps pictures per second
     * @throws IOException if the camera cannot be opened
     */
    void open(int w, int h, int format, int field, int fps) throws IOException;

    /**
     * Opens the camera with its usual format.
     *
     * @throws IOException if the camera cannot be opened
     */
    void open(int w, int h) throws IOException;

    /**
     * Reads a picture.
     *
     * @return number of bytes
     * @throws IOException if the camera fails
     */
    int grabFrame(byte[] frame) throws IOException;

    /**
     * Closes the camera.
     *
     * @throws IOException if the camera fails
     */
    void close() throws IOException;

    /** Memory for a picture. */
    byte[] createFrame();

    /** Width in pixels. */
    int getWidth();

    /** Height in pixels. */
    int getHeight();
}
