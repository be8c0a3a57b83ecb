package brickless.device.sensor;

import brickless.world.Paint;
import brickless.world.Region;
import brickless.world.World;
import java.util.List;
import java.util.Optional;

/** Looks a world's paint up point by point. */
final class PaintedFloor implements FloorColour {
    private static final int WHITE = 0xffffff;
    private static final int NO_FLOOR = -1;
    private final List<Paint> paints;
    private final Optional<Region> table;

    PaintedFloor(World world) {
        paints = world.floor();
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
        for (int i = paints.size() - 1; i >= 0 && rest > 0; i--) {
            Paint paint = paints.get(i);
            if (paint.opacity() > 0 && paint.region().contains(x, y)) {
                red += rest * paint.opacity() * paint.colour().red();
                green += rest * paint.opacity() * paint.colour().green();
                blue += rest * paint.opacity() * paint.colour().blue();
                rest *= 1 - paint.opacity();
            }
        }
        int white = WHITE & 255;
        return component(red + rest * white) << 16 | component(green + rest * white) << 8 | component(blue + rest * white);
    }

    private static int component(double value) {
        return (int) Math.max(0, Math.min(255, Math.round(value)));
    }
}
