package brickless.device.sensor;

import java.util.Optional;

/** NXT colour sensor, looking down: four voltages and a colour number. */
final class NxtColourSensor extends AnalogSensor {
    private static final int DEVICE = 4;
    private static final int FULL = 13;
    private static final int RED_LAMP = 14;
    private static final int GREEN_LAMP = 15;
    private static final int BLUE_LAMP = 16;
    /** Voltage over black and over white paper: assumption. */
    private static final double BLACK_VOLTS = 0.3;
    private static final double WHITE_VOLTS = 2.3;
    /** Voltage of the background in a dark room, and at how many lux it is half the range: assumptions. */
    private static final double DARK_VOLTS = 0.1;
    private static final double HALF_SCALE_LUX = 1500;
    private static final double NOISE = 0.004;

    private final ColourEye eye;
    private final float[] volts = new float[5];
    private int type = FULL;

    NxtColourSensor(SensorSite site) {
        super(site);
        eye = new ColourEye(site);
    }

    @Override
    int deviceType() {
        return DEVICE;
    }

    @Override
    void setType(int newType) {
        type = newType;
    }

    @Override
    double pin1Volts(long nowNanos) {
        return 0;
    }

    @Override
    float[] colourVolts(long nowNanos) {
        eye.look();
        long update = nowNanos / SAMPLE_NANOS;
        double lux = eye.ambientLux();
        double background = DARK_VOLTS + (WHITE_VOLTS - DARK_VOLTS) * lux / (lux + HALF_SCALE_LUX);
        volts[0] = lit(RED_LAMP, eye.red(), background, update, 0);
        volts[1] = lit(GREEN_LAMP, eye.green(), background, update, 1);
        volts[2] = lit(BLUE_LAMP, eye.blue(), background, update, 2);
        volts[3] = (float) background;
        volts[4] = colourId();
        return volts.clone();
    }

    private float lit(int lamp, double reflectance, double background, long update, int lane) {
        boolean on = type == FULL || type == lamp;
        double clean = on ? BLACK_VOLTS + (WHITE_VOLTS - BLACK_VOLTS) * reflectance : background;
        return (float) (clean + NOISE * site().noise().bell(update, lane));
    }

    /** The NXT sensor knows no brown: it takes it for red. */
    private int colourId() {
        if (eye.floorless()) {
            return ColourClassifier.NONE;
        }
        int id = ColourClassifier.classify(eye.red(), eye.green(), eye.blue());
        return id == ColourClassifier.BROWN ? ColourClassifier.RED : id;
    }

    @Override
    double[] reading(long nowNanos) {
        eye.look();
        return new double[] {colourId()};
    }

    @Override
    Optional<SensorSpot> spot() {
        return Optional.of(eye.spot(true));
    }
}
