package brickless.device.sensor;

/** NXT sound sensor: the louder, the lower the voltage of pin 1. */
final class NxtSoundSensor extends AnalogSensor {
    private static final int DEVICE = 3;
    private static final int WEIGHTED = 8;
    /** Softest and loudest sound told apart, decibels: assumption (LEGO: up to 90 dB). */
    private static final double SOFTEST = 30;
    private static final double LOUDEST = 90;
    /** How much less the ear-weighted range hears: assumption. */
    private static final double WEIGHTED_PART = 0.9;
    private static final double NOISE = 0.004;

    private double part = 1;

    NxtSoundSensor(SensorSite site) {
        super(site);
    }

    @Override
    int deviceType() {
        return DEVICE;
    }

    @Override
    void setType(int type) {
        part = type == WEIGHTED ? WEIGHTED_PART : 1;
    }

    @Override
    double pin1Volts(long nowNanos) {
        return PULL_UP_VOLTS * (1 - level(nowNanos));
    }

    /** Part of full scale, 0 to 1. */
    private double level(long nowNanos) {
        double level = (site().surroundings().arena().sound().decibels() - SOFTEST) / (LOUDEST - SOFTEST);
        return Math.max(0, Math.min(1, part * level + NOISE * site().noise().bell(nowNanos / SAMPLE_NANOS, 0)));
    }

    @Override
    double[] reading(long nowNanos) {
        return new double[] {level(nowNanos)};
    }
}
