package brickless.device.sensor;

import brickless.units.Angles;

/**
 * EV3 gyro, label up: clockwise positive, as the device sends it. Any change of mode starts the angle at 0 and
 * calibrates the rate.
 */
final class GyroSensor extends UartSensor implements SelfActing {
    private static final int DEVICE = 32;
    /** Period of measurements, nanoseconds. */
    private static final long PERIOD_NANOS = 1_000_000;
    private static final double NANOS_PER_SECOND = 1e9;
    /** Fastest turn that is measured, degrees per second. */
    private static final double FASTEST = 440;
    private static final int LARGEST_ANGLE = 32767;
    /** Error of the angle's scale, largest part: assumption, makes 90° wrong by up to 2° (LEGO says ±3°). */
    private static final double SCALE_ERROR = 0.02;
    /** Rate left over after calibrating at rest, largest, degrees per second: assumption. */
    private static final double RESIDUAL_RATE = 0.02;
    /** Standard deviation of the rate, degrees per second: assumption. */
    private static final double RATE_NOISE = 0.3;
    private static final int RATE = 1;
    private static final int FAST = 2;
    private static final int ANGLE_AND_RATE = 3;
    private static final int CALIBRATION = 4;

    private final double scale;
    private double angle;
    private double rate;
    private double bias;
    private double lastHeading;

    GyroSensor(SensorSite site) {
        super(site, DEVICE, UartMode.quick("GYRO-ANG", 1, 2), UartMode.quick("GYRO-RATE", 1, 2),
                UartMode.quick("GYRO-FAS", 1, 2),
                UartMode.quick("GYRO-G&A", 2, 2), UartMode.quick("GYRO-CAL", 4, 2));
        scale = 1 + SCALE_ERROR * site.noise().even(0, 7);
        lastHeading = aim().headingRadians;
    }

    /** A rate that is there while calibrating is taken for zero: from then on the angle drifts. */
    @Override
    void selected(long nowNanos) {
        angle = 0;
        bias = rate + RESIDUAL_RATE * site().noise().even(nowNanos / PERIOD_NANOS, 8);
    }

    @Override
    public void afterStep(long nowNanos) {
        double heading = aim().headingRadians;
        double seconds = site().surroundings().arena().stepNanos() / NANOS_PER_SECOND;
        double turned = Angles.degreesFromRadians(heading - lastHeading);
        rate = Math.max(-FASTEST, Math.min(FASTEST, turned / seconds));
        angle += (rate * scale - bias) * seconds;
        lastHeading = heading;
    }

    private int angleDegrees() {
        return (int) Math.max(-LARGEST_ANGLE, Math.min(LARGEST_ANGLE, Math.round(angle)));
    }

    private int rateDegreesPerSecond(long nowNanos) {
        double noisy = rate * scale - bias + RATE_NOISE * site().noise().bell(nowNanos / PERIOD_NANOS, 0);
        return (int) Math.max(-FASTEST, Math.min(FASTEST, Math.round(noisy)));
    }

    @Override
    void message(long nowNanos, byte[] out) {
        switch (mode()) {
            case RATE, FAST -> putShort(out, 0, rateDegreesPerSecond(nowNanos));
            case ANGLE_AND_RATE -> {
                putShort(out, 0, angleDegrees());
                putShort(out, 1, rateDegreesPerSecond(nowNanos));
            }
            case CALIBRATION -> {
                for (int i = 0; i < 4; i++) {
                    putShort(out, i, 0);
                }
            }
            default -> putShort(out, 0, angleDegrees());
        }
    }
}
