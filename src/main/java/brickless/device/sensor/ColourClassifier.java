package brickless.device.sensor;

/**
 * Names a colour the way LEGO's sensor does: 0 none, 1 black, 2 blue, 3 green, 4 yellow, 5 red, 6 white, 7 brown. The
 * limits are assumptions.
 */
final class ColourClassifier {
    static final int NONE = 0;
    static final int BLACK = 1;
    static final int BLUE = 2;
    static final int GREEN = 3;
    static final int YELLOW = 4;
    static final int RED = 5;
    static final int WHITE = 6;
    static final int BROWN = 7;

    /** Below this reflectance nothing can be told from black. */
    private static final double DARK = 0.045;
    /** From this reflectance a colour without hue is white. */
    private static final double BRIGHT = 0.22;
    /** Below this part of the brightest channel (1 = grey), a colour has a hue. */
    private static final double GREYISH = 0.62;
    /** Red to yellow hues darker than this are brown. */
    private static final double BROWN_BELOW = 0.40;
    private static final double RED_UP_TO = 10;
    private static final double ORANGE_UP_TO = 22;
    private static final double YELLOW_UP_TO = 72;
    private static final double GREEN_UP_TO = 165;
    private static final double BLUE_UP_TO = 285;

    private ColourClassifier() {}

    /** Classifies reflectances, linear, 0 to 1, relative to white paper. */
    static int classify(double red, double green, double blue) {
        double most = Math.max(red, Math.max(green, blue));
        double least = Math.min(red, Math.min(green, blue));
        if (most < DARK) {
            return BLACK;
        }
        if (least > GREYISH * most) {
            return most >= BRIGHT ? WHITE : BLACK;
        }
        return byHue(hue(red, green, blue, most, least), most);
    }

    private static int byHue(double hue, double brightness) {
        if (hue > RED_UP_TO && hue <= YELLOW_UP_TO && hue <= 50 && brightness < BROWN_BELOW) {
            return BROWN;
        }
        if (hue <= ORANGE_UP_TO) {
            return RED;
        }
        if (hue <= YELLOW_UP_TO) {
            return YELLOW;
        }
        if (hue <= GREEN_UP_TO) {
            return GREEN;
        }
        return hue <= BLUE_UP_TO ? BLUE : RED;
    }

    /** Hue in degrees: 0 red, 120 green, 240 blue. */
    private static double hue(double red, double green, double blue, double most, double least) {
        double range = most - least;
        if (most == red) {
            double hue = 60 * (green - blue) / range;
            return hue < 0 ? hue + 360 : hue;
        }
        return most == green ? 120 + 60 * (blue - red) / range : 240 + 60 * (red - green) / range;
    }
}
