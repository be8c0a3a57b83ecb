package brickless.world.svg;

import brickless.world.Point2;
import java.util.List;

/**
 * One connected run of straight pieces, in the user units of its element; {@code closed} joins the last point to the
 * first.
 */
record SubPath(List<Point2> points, boolean closed) {
    SubPath {
        points = List.copyOf(points);
    }
}
