package lejos.robotics.mapping;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Rectangle;

/**
 * Reads the lines and polygons of an ESRI shapefile ({@code .shp}) as a map.
 *
 * <p>Format: "ESRI Shapefile Technical Description", 1998. Lengths in headers are big-endian and count 16-bit words,
 * the rest is little-endian.
 */
public class ShapefileLoader {
    private static final int FILE_CODE = 0x0000270a;
    private static final int BYTES_TO_BOUNDS = 32;
    private static final int BYTES_AFTER_BOUNDS = 32;
    private static final int BYTES_OF_BOX = 32;
    private static final int BYTES_PER_WORD = 2;
    private static final int POLYLINE = 3;
    private static final int POLYGON = 5;

    private final DataInputStream in;

    /** A loader of one map. */
    public ShapefileLoader(InputStream in) {
        this.in = new DataInputStream(in);
    }

    /**
     * The map; its rectangle is the one the file states.
     *
     * @throws IOException if the file is none or ends early
     */
    public LineMap readLineMap() throws IOException {
        if (in.readInt() != FILE_CODE) {
            throw new IOException("not a shapefile");
        }
        in.readFully(new byte[BYTES_TO_BOUNDS]);
        float minX = (float) readDouble();
        float minY = (float) readDouble();
        float maxX = (float) readDouble();
        float maxY = (float) readDouble();
        in.readFully(new byte[BYTES_AFTER_BOUNDS]);
        List<Line> lines = new ArrayList<>();
        while (hasRecord()) {
            readRecord(lines);
        }
        return new LineMap(lines.toArray(new Line[0]), new Rectangle(minX, minY, maxX - minX, maxY - minY));
    }

    /** Reads the number of the next record. */
    private boolean hasRecord() throws IOException {
        try {
            in.readInt();
            return true;
        } catch (EOFException end) {
            return false;
        }
    }

    private void readRecord(List<Line> lines) throws IOException {
        int bytes = in.readInt() * BYTES_PER_WORD;
        int type = readInt();
        if (type == POLYLINE || type == POLYGON) {
            in.readFully(new byte[BYTES_OF_BOX]);
            readParts(lines);
        } else {
            in.readFully(new byte[bytes - Integer.BYTES]);
        }
    }

    private void readParts(List<Line> lines) throws IOException {
        int[] starts = new int[readInt() + 1];
        int points = readInt();
        for (int i = 0; i < starts.length - 1; i++) {
            starts[i] = readInt();
        }
        starts[starts.length - 1] = points;
        for (int part = 0; part + 1 < starts.length; part++) {
            readPart(lines, starts[part + 1] - starts[part]);
        }
    }

    private void readPart(List<Line> lines, int points) throws IOException {
        float lastX = 0;
        float lastY = 0;
        for (int i = 0; i < points; i++) {
            float x = (float) readDouble();
            float y = (float) readDouble();
            if (i > 0) {
                lines.add(new Line(lastX, lastY, x, y));
            }
            lastX = x;
            lastY = y;
        }
    }

    private int readInt() throws IOException {
        return Integer.reverseBytes(in.readInt());
    }

    private double readDouble() throws IOException {
        return Double.longBitsToDouble(Long.reverseBytes(in.readLong()));
    }
}
