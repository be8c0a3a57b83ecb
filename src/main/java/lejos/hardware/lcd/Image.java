package lejos.hardware.lcd;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.Serializable;
import lejos.internal.ev3.EV3GraphicsLCD;

/** A black and white picture in memory: rows of {@code (width + 7) / 8} bytes, lowest bit leftmost, 1 = black. */
public class Image implements Serializable {
    private static final long serialVersionUID = 1L;
    private static final int FILE_MAGIC = 0x4c4e4930;

    private final int width;
    private final int height;
    private final byte[] data;

    /** Wraps existing memory, which stays shared. */
    public Image(int width, int height, byte[] data) {
        this.width = width;
        this.height = height;
        this.data = data;
    }

    /** A white picture. */
    public static Image createImage(int w, int h) {
        return new Image(w, h, new byte[storage(w, h)]);
    }

    /**
     * Reads a leJOS image file: magic number {@code LNI0}, width and height as 16-bit numbers, then {@code width ×
     * ((height + 7) / 8)} bytes.
     *
     * @throws IOException if the stream cannot be read or is no image
     */
    public static Image createImage(InputStream s) throws IOException {
        DataInputStream in = new DataInputStream(s);
        if (in.readInt() != FILE_MAGIC) {
            throw new IOException("File format error!");
        }
        int width = in.readUnsignedShort();
        int height = in.readUnsignedShort();
        byte[] data = new byte[storage(width, height)];
        in.readFully(data, 0, fileBytes(width, height));
        return new Image(width, height, data);
    }

    /**
     * A transformed copy of a part of a picture.
     *
     * @param transform one of the {@code TRANS_} constants of {@link GraphicsLCD}
     */
    public static Image createImage(Image image, int x, int y, int w, int h, int transform) {
        boolean turned = transform >= GraphicsLCD.TRANS_MIRROR_ROT270;
        Image result = turned ? createImage(h, w) : createImage(w, h);
        result.getGraphics().drawRegion(image, x, y, w, h, transform, 0, 0, 0);
        return result;
    }

    /** The size leJOS uses, or more where that would not hold all rows. */
    private static int storage(int w, int h) {
        return Math.max(fileBytes(w, h), (w + 7) / 8 * h);
    }

    private static int fileBytes(int w, int h) {
        return w * ((h + 7) / 8);
    }

    /** Width in pixels. */
    public int getWidth() {
        return width;
    }

    /** Height in pixels. */
    public int getHeight() {
        return height;
    }

    /** The live memory of the picture. */
    public byte[] getData() {
        return data;
    }

    /** A new object that draws on this picture. */
    public GraphicsLCD getGraphics() {
        return new EV3GraphicsLCD(data, width, height);
    }
}
