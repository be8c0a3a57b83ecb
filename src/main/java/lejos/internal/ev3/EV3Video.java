package lejos.internal.ev3;

import java.io.IOException;
import lejos.hardware.video.Video;

/** The camera of a virtual brick: there is none. */
public class EV3Video implements Video {
    private static final String NO_CAMERA = "no camera is plugged into a virtual brick";

    /** No camera. */
    public EV3Video() {}

    @Override
    public void open(int w, int h, int format, int field, int fps) throws IOException {
        throw new IOException(NO_CAMERA);
    }

    @Override
    public void open(int w, int h) throws IOException {
        throw new IOException(NO_CAMERA);
    }

    @Override
    public int grabFrame(byte[] frame) throws IOException {
        throw new IOException(NO_CAMERA);
    }

    @Override
    public void close() throws IOException {
        // Never open.
    }

    @Override
    public byte[] createFrame() {
        return new byte[0];
    }

    @Override
    public int getWidth() {
        return 0;
    }

    @Override
    public int getHeight() {
        return 0;
    }
}
