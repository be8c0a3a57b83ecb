package brickless.device.sensor;

import brickless.physics.Aim;
import brickless.world.Point2;
import brickless.world.Rgb;
import java.util.Optional;

/** What a downward-looking sensor sees of the floor: the average of a round spot, in linear light. */
final class ColourEye {
    /** Height for which the sensor is made, and the radius of its spot there, metres. */
    private static final double BEST_HEIGHT = 0.008;
    private static final double BEST_RADIUS = 0.005;
    /** How fast the returned light fades above the best height, metres: assumption. */
    private static final double FADING = 0.012;
    private static final int[] RING_POINTS = {1, 6, 12};
    private static final double[] RING_RADII = {0, 0.45, 0.85};
    private static final int POINTS = 19;
    private static final double[] OFFSETS = offsets();
    private static final double[] LINEAR = linear();

    private final SensorSite site;
    private final double radius;
    private final double returned;
    private double red;
    private double green;
    private double blue;
    private boolean floorless;
    private double x = Double.NaN;
    private double y = Double.NaN;

    ColourEye(SensorSite site) {
        this.site = site;
        double height = Math.max(BEST_HEIGHT / 2, site.mount().heightMetres());
        this.radius = BEST_RADIUS * height / BEST_HEIGHT;
        double fade = (BEST_HEIGHT + FADING) / (Math.max(BEST_HEIGHT, height) + FADING);
        this.returned = fade * fade;
    }

    private static double[] offsets() {
        double[] offsets = new double[2 * POINTS];
        int k = 0;
        for (int ring = 0; ring < RING_POINTS.length; ring++) {
            for (int i = 0; i < RING_POINTS[ring]; i++) {
                double angle = 2 * StrictMath.PI * (i + 0.25 * ring) / RING_POINTS[ring];
                offsets[k++] = RING_RADII[ring] * StrictMath.cos(angle);
                offsets[k++] = RING_RADII[ring] * StrictMath.sin(angle);
            }
        }
        return offsets;
    }

    /** sRGB components 0 to 255 to linear light 0 to 1 (IEC 61966-2-1). */
    private static double[] linear() {
        double[] table = new double[256];
        for (int i = 0; i < table.length; i++) {
            double c = i / 255.0;
            table[i] = c <= 0.04045 ? c / 12.92 : StrictMath.pow((c + 0.055) / 1.055, 2.4);
        }
        return table;
    }

    /** Looks at the floor below the sensor; repeated looks from one place cost nothing. */
    void look() {
        Aim aim = site.aim();
        if (aim.x == x && aim.y == y) {
            return;
        }
        x = aim.x;
        y = aim.y;
        red = 0;
        green = 0;
        blue = 0;
        floorless = true;
        for (int i = 0; i < POINTS; i++) {
            int colour = site.surroundings().floor().at(x + radius * OFFSETS[2 * i], y + radius * OFFSETS[2 * i + 1]);
            if (colour >= 0) {
                floorless = false;
                red += LINEAR[colour >> 16 & 255];
                green += LINEAR[colour >> 8 & 255];
                blue += LINEAR[colour & 255];
            }
        }
    }

    /** What it looks at, with its colour if the sensor is on. */
    SensorSpot spot(boolean on) {
        look();
        Optional<Rgb> colour = on && !floorless ? Optional.of(new Rgb(drawn(red), drawn(green), drawn(blue)))
                : Optional.empty();
        return new SensorSpot(new Point2(x, y), radius, colour);
    }

    /** Mean of linear light back to sRGB. */
    private static int drawn(double sum) {
        double c = sum / POINTS;
        double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * StrictMath.pow(c, 1 / 2.4) - 0.055;
        return (int) Math.max(0, Math.min(255, Math.round(255 * encoded)));
    }

    /** Reflectance for red light, 0 to 1, faded by height. */
    double red() {
        return red / POINTS * returned;
    }

    /** Reflectance for green light. */
    double green() {
        return green / POINTS * returned;
    }

    /** Reflectance for blue light. */
    double blue() {
        return blue / POINTS * returned;
    }

    /** Whether there is no floor at all below, as over the edge of a table. */
    boolean floorless() {
        return floorless;
    }

    /** Light of the room that the floor throws back at the sensor, lux. */
    double ambientLux() {
        return site.surroundings().lux(x, y) * (0.2 + 0.8 * (red + green + blue) / (3 * POINTS));
    }
}
