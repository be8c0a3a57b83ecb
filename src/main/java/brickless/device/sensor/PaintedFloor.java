package brickless.device.sensor;

import brickless.world.Paint;
import brickless.world.Region;
import brickless.world.Rgb;
import brickless.world.World;
import java.util.List;
import java.util.Optional;

/** Looks a world's paint up point by point, topmost first, upon white. */
final class PaintedFloor implements FloorColour {
    private static final int WHITE = 255;
    private static final int NO_FLOOR = -1;
    private static final int OPAQUE = 255;
    /** Once less than this part of the ground shines through, it makes no difference. */
    private static final double COVERED = 1e-3;

    private final List<Paint> paints;
    private final double[][] bounds;
    private final Optional<Region> table;

    PaintedFloor(World world) {
        paints = world.floor();
        bounds = paints.stream().map(Paint::region).map(Region::bounds).toArray(double[][]::new);
        table = world.table();
    }

    @Override public int at(double x, double y) {
        if (table.isPresent() && !table.get().contains(x, y)) {
            return NO_FLOOR;
        }
        double rest = 1;
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int i = paints.size() - 1; i >= 0 && rest > COVERED; i--) {
            if (covers(i, x, y)) {
                int argb = argb(paints.get(i), x, y);
                double cover = rest * paints.get(i).opacity() * (argb >>> 24) / OPAQUE;
                red += cover * (argb >> 16 & 255);
                green += cover * (argb >> 8 & 255);
                blue += cover * (argb & 255);
                rest -= cover;
            }
        }
        double ground = rest * WHITE;
        return component(red + ground) << 16 | component(green + ground) << 8 | component(blue + ground);
    }

    private boolean covers(int i, double x, double y) {
        double[] box = bounds[i];
        return x >= box[0] && y >= box[1] && x <= box[2] && y <= box[3] && paints.get(i).region().contains(x, y);
    }

    private static int argb(Paint paint, double x, double y) {
        if (paint.texture().isPresent()) {
            return paint.texture().get().argbAt(x, y);
        }
        Rgb colour = paint.colour();
        return OPAQUE << 24 | colour.red() << 16 | colour.green() << 8 | colour.blue();
    }

    private static int component(double value) {
        return (int) Math.max(0, Math.min(255, Math.round(value)));
    }
}
