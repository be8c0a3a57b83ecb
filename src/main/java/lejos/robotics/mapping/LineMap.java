package lejos.robotics.mapping;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import lejos.robotics.Transmittable;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Point;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.navigation.Pose;

/** A map of walls, each a line without thickness. The lines around the mapped area should form closed figures. */
public class LineMap implements RangeMap, Transmittable {
    /** How far {@link #range} looks. */
    private static final float SIGHT = 254;

    private Line[] lines;
    private Rectangle boundingRect;

    /**
     * A map.
     *
     * @param lines the walls; not copied
     * @param boundingRect a rectangle around them; not copied
     */
    public LineMap(Line[] lines, Rectangle boundingRect) {
        this.lines = lines;
        this.boundingRect = boundingRect;
    }

    /** A map to be filled by {@link #loadObject}. */
    public LineMap() {
    }

    /** Distance from a pose, along its heading, to the nearest wall within 254 units; −1 if there is none. */
    @Override
    public float range(Pose p) {
        Point end = p.pointAt(SIGHT, p.getHeading());
        Line sight = new Line(p.getX(), p.getY(), end.x, end.y);
        float nearest = -1;
        for (Line wall : lines) {
            Point hit = wall.intersectsAt(sight);
            if (hit != null) {
                float distance = p.distanceTo(hit);
                nearest = nearest < 0 ? distance : Math.min(nearest, distance);
            }
        }
        return nearest;
    }

    /**
     * Whether a point is in the mapped area: whether a ray from it to the left meets an odd number of lines. A ray
     * through a corner meets two lines there, so a point level with a corner may be misjudged.
     */
    @Override
    public boolean inside(Point p) {
        if (p.x < boundingRect.x || p.y < boundingRect.y
                || p.x > boundingRect.x + boundingRect.width || p.y > boundingRect.y + boundingRect.height) {
            return false;
        }
        Line ray = new Line(p.x, p.y, p.x - boundingRect.width, p.y);
        int met = 0;
        for (Line wall : lines) {
            if (wall.intersectsAt(ray) != null) {
                met++;
            }
        }
        return met % 2 == 1;
    }

    @Override
    public Rectangle getBoundingRect() {
        return boundingRect;
    }

    /** Writes the number of lines, the ends of each, and the rectangle as x, y, width and height. */
    @Override
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeInt(lines.length);
        for (Line line : lines) {
            write(dos, line.x1, line.y1, line.x2, line.y2);
        }
        write(dos, boundingRect.x, boundingRect.y, boundingRect.width, boundingRect.height);
        dos.flush();
    }

    @Override
    public void loadObject(DataInputStream dis) throws IOException {
        lines = new Line[dis.readInt()];
        for (int i = 0; i < lines.length; i++) {
            float[] ends = read(dis);
            lines[i] = new Line(ends[0], ends[1], ends[2], ends[3]);
        }
        float[] corner = read(dis);
        boundingRect = new Rectangle(corner[0], corner[1], corner[2], corner[3]);
    }

    /** The walls: the map's own array. */
    public Line[] getLines() {
        return lines;
    }

    /** Draws the map to an SVG file, one pixel per unit, y downward. */
    public void createSVGFile(String fileName) throws IOException {
        Rectangle r = boundingRect;
        try (Writer out = new OutputStreamWriter(new FileOutputStream(fileName), StandardCharsets.UTF_8)) {
            out.write("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + r.width + "px\" height=\"" + r.height
                    + "px\" viewBox=\"" + r.x + " " + r.y + " " + r.width + " " + r.height + "\">\n<g>\n");
            for (Line line : lines) {
                out.write("<line stroke=\"#000000\" x1=\"" + line.x1 + "\" y1=\"" + line.y1
                        + "\" x2=\"" + line.x2 + "\" y2=\"" + line.y2 + "\"/>\n");
            }
            out.write("</g>\n</svg>\n");
        }
    }

    /**
     * A map with y counted from the top of the rectangle down, or back up again; the rectangle, shared, should begin at
     * y = 0.
     */
    public LineMap flip() {
        float top = boundingRect.y + boundingRect.height;
        Line[] flipped = new Line[lines.length];
        for (int i = 0; i < lines.length; i++) {
            Line line = lines[i];
            flipped[i] = new Line(line.x1, top - line.y1, line.x2, top - line.y2);
        }
        return new LineMap(flipped, boundingRect);
    }

    private static void write(DataOutputStream dos, float... values) throws IOException {
        for (float value : values) {
            dos.writeFloat(value);
        }
    }

    private static float[] read(DataInputStream dis) throws IOException {
        return new float[] {dis.readFloat(), dis.readFloat(), dis.readFloat(), dis.readFloat()};
    }
}
