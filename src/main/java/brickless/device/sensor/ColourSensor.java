package brickless.device.sensor;

import java.util.Optional;

/** EV3 colour sensor, looking down on the floor. */
final class ColourSensor extends UartSensor {
    private static final int DEVICE = 29;
    /** Period of measurements, nanoseconds. */
    private static final long PERIOD_NANOS = 1_000_000;
    private static final int REFLECT = 0;
    private static final int AMBIENT = 1;
    private static final int COLOUR = 2;
    private static final int REFLECT_RAW = 3;
    private static final int RGB = 4;
    /**
     * Reflected percentage of a perfectly black and of a white floor: assumption, from users' readings (0.03–0.1 and
     * 0.6–0.9).
     */
    private static final double BLACK_PERCENT = 5;
    private static final double WHITE_PERCENT = 78;
    /**
     * Largest raw value, and raw values of white paper, per channel: assumption, from users' readings (0.2–0.35 of
     * 1020).
     */
    private static final int RAW_MAX = 1020;
    private static final double WHITE_RED = 285;
    private static final double WHITE_GREEN = 310;
    private static final double WHITE_BLUE = 225;
    /** Part of the light that comes back from a perfectly black floor: assumption. */
    private static final double BLACK_RETURN = 0.09;
    private static final double RAW_NOISE = 1.2;
    private static final double PERCENT_NOISE = 0.4;
    /** Illuminance that reads 50 % in ambient mode, lux: assumption. */
    private static final double HALF_SCALE_LUX = 1500;
    /** Higher above the floor than this, colours are not told, metres: assumption. */
    private static final double NOTHING_HEIGHT = 0.04;

    private final ColourEye eye;

    ColourSensor(SensorSite site) {
        super(site, DEVICE, UartMode.quick("COL-REFLECT", 1, 1), UartMode.quick("COL-AMBIENT", 1, 1),
                UartMode.quick("COL-COLOR", 1, 1),
                UartMode.quick("REF-RAW", 2, 2), UartMode.quick("RGB-RAW", 3, 2), UartMode.quick("COL-CAL", 4, 2));
        eye = new ColourEye(site);
    }

    @Override
    void message(long nowNanos, byte[] out) {
        eye.look();
        long update = nowNanos / PERIOD_NANOS;
        switch (mode()) {
            case REFLECT -> out[0] = (byte) reflectPercent(update);
            case AMBIENT -> out[0] = (byte) ambientPercent(update);
            case COLOUR -> out[0] = (byte) colourId();
            case REFLECT_RAW -> {
                putShort(out, 0, RAW_MAX - (int) Math.round(reflectPercent(update) * 5.0));
                putShort(out, 1, RAW_MAX);
            }
            default -> putRgb(update, out);
        }
    }

    private void putRgb(long update, byte[] out) {
        putShort(out, 0, raw(eye.red(), WHITE_RED, update, 0));
        putShort(out, 1, raw(eye.green(), WHITE_GREEN, update, 1));
        putShort(out, 2, raw(eye.blue(), WHITE_BLUE, update, 2));
        if (mode() != RGB) {
            putShort(out, 3, 0);
        }
    }

    private int raw(double reflectance, double white, long update, int lane) {
        double clean = white * (BLACK_RETURN + (1 - BLACK_RETURN) * reflectance);
        return clamp(clean + RAW_NOISE * site().noise().bell(update, lane), RAW_MAX);
    }

    private int reflectPercent(long update) {
        double clean = BLACK_PERCENT + (WHITE_PERCENT - BLACK_PERCENT) * eye.red();
        return clamp(clean + PERCENT_NOISE * site().noise().bell(update, 0), 100);
    }

    private int ambientPercent(long update) {
        double lux = eye.ambientLux();
        return clamp(100 * lux / (lux + HALF_SCALE_LUX) + PERCENT_NOISE * site().noise().bell(update, 0), 100);
    }

    private int colourId() {
        return eye.floorless() || site().mount().heightMetres() > NOTHING_HEIGHT ? ColourClassifier.NONE
                : ColourClassifier.classify(eye.red(), eye.green(), eye.blue());
    }

    private static int clamp(double value, int most) {
        return (int) Math.max(0, Math.min(most, Math.round(value)));
    }

    @Override
    Optional<SensorSpot> spot() {
        return Optional.of(eye.spot(mode() != DARK));
    }
}
