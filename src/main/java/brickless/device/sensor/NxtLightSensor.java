package brickless.device.sensor;

import java.util.Optional;

/** NXT light sensor, looking down: the brighter, the lower the voltage of pin 1. */
final class NxtLightSensor extends AnalogSensor {
    private static final int DEVICE = 2;
    private static final int LAMP_ON = 5;
    private static final int RCX_LAMP_ON = 3;
    /** Part of full scale with the lamp on over black and over white paper: assumption, from users' readings. */
    private static final double BLACK = 0.30;
    private static final double WHITE = 0.62;
    /** Part of full scale without light, and illuminance of half the rest, lux: assumptions. */
    private static final double NIGHT = 0.10;
    private static final double HALF_SCALE_LUX = 1000;
    private static final double NOISE = 0.002;

    private final ColourEye eye;
    private boolean lamp;

    NxtLightSensor(SensorSite site) {
        super(site);
        eye = new ColourEye(site);
    }

    @Override
    int deviceType() {
        return DEVICE;
    }

    @Override
    void setType(int type) {
        lamp = type == LAMP_ON || type == RCX_LAMP_ON;
    }

    @Override
    void powerOff() {
        lamp = false;
    }

    @Override
    double pin1Volts(long nowNanos) {
        return PULL_UP_VOLTS * (1 - level(nowNanos));
    }

    /** Part of full scale, 0 to 1. */
    private double level(long nowNanos) {
        eye.look();
        double lux = eye.ambientLux();
        double clean = lamp ? BLACK + (WHITE - BLACK) * (0.7 * eye.red() + 0.2 * eye.green() + 0.1 * eye.blue())
                : NIGHT + (1 - NIGHT) * lux / (lux + HALF_SCALE_LUX);
        return Math.max(0, Math.min(1, clean + NOISE * site().noise().bell(nowNanos / SAMPLE_NANOS, 0)));
    }

    @Override
    double[] reading(long nowNanos) {
        return new double[] {level(nowNanos)};
    }

    @Override
    Optional<SensorSpot> spot() {
        return Optional.of(eye.spot(true));
    }
}
