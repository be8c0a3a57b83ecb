package brickless.device.panel;

import brickless.hardware.ScreenSocket;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.zip.Adler32;
import java.util.zip.CRC32;

/**
 * Pictures of the screen as PNG files: two pixels per dot on the grey-green of the brick's display, with a small
 * margin. The same picture gives the same bytes everywhere.
 */
public final class ScreenImage {
    /** Pixels per dot. */
    public static final int SCALE = 2;
    /** Margin around the picture in pixels. */
    public static final int MARGIN = 8;
    /** Width of the file's picture in pixels. */
    public static final int WIDTH = ScreenSocket.WIDTH * SCALE + 2 * MARGIN;
    /** Height of the file's picture in pixels. */
    public static final int HEIGHT = ScreenSocket.HEIGHT * SCALE + 2 * MARGIN;

    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    /** Palette: display background, ink. */
    private static final byte[] PALETTE = {(byte) 0xb5, (byte) 0xc2, (byte) 0xa6, 0x1e, 0x26, 0x1c};

    private ScreenImage() {}

    /** Encodes a picture of {@code ScreenSocket.ROW_BYTES × HEIGHT} bytes. */
    public static byte[] png(byte[] picture) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.writeBytes(SIGNATURE);
        chunk(file, "IHDR", header());
        chunk(file, "PLTE", PALETTE);
        chunk(file, "IDAT", stored(rows(picture)));
        chunk(file, "IEND", new byte[0]);
        return file.toByteArray();
    }

    private static byte[] header() {
        byte oneBitPerPixel = 1;
        byte indexedColour = 3;
        return new byte[] {
            0, 0, (byte) (WIDTH >> 8), (byte) WIDTH, 0, 0, (byte) (HEIGHT >> 8), (byte) HEIGHT, oneBitPerPixel,
                    indexedColour, 0, 0, 0
        };
    }

    /** The pixel rows, each preceded by filter type 0; in PNG the highest bit is the leftmost pixel. */
    private static byte[] rows(byte[] picture) {
        int rowBytes = 1 + (WIDTH + 7) / 8;
        byte[] rows = new byte[rowBytes * HEIGHT];
        for (int y = 0; y < ScreenSocket.HEIGHT * SCALE; y++) {
            for (int x = 0; x < ScreenSocket.WIDTH * SCALE; x++) {
                int dotX = x / SCALE;
                if ((picture[y / SCALE * ScreenSocket.ROW_BYTES + (dotX >> 3)] >> (dotX & 7) & 1) != 0) {
                    int column = x + MARGIN;
                    rows[(y + MARGIN) * rowBytes + 1 + (column >> 3)] |= (byte) (0x80 >> (column & 7));
                }
            }
        }
        return rows;
    }

    /** A zlib stream of one stored block: uncompressed, so that it does not depend on the machine's zlib. */
    private static byte[] stored(byte[] bytes) {
        Adler32 check = new Adler32();
        check.update(bytes);
        ByteBuffer stream = ByteBuffer.allocate(bytes.length + 11).order(ByteOrder.LITTLE_ENDIAN);
        stream.put((byte) 0x78).put((byte) 0x01);
        stream.put((byte) 1).putShort((short) bytes.length).putShort((short) ~bytes.length).put(bytes);
        stream.order(ByteOrder.BIG_ENDIAN).putInt((int) check.getValue());
        return stream.array();
    }

    private static void chunk(ByteArrayOutputStream file, String type, byte[] content) {
        ByteBuffer chunk = ByteBuffer.allocate(content.length + 12);
        chunk.putInt(content.length).put(type.getBytes(StandardCharsets.US_ASCII)).put(content);
        CRC32 check = new CRC32();
        check.update(chunk.array(), 4, content.length + 4);
        file.writeBytes(chunk.putInt((int) check.getValue()).array());
    }
}
