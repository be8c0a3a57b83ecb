package brickless.device.sensor;

import java.util.Optional;

/** NXT ultrasonic sensor on the I²C bus: distance in whole centimetres in its registers. */
final class NxtUltrasonicSensor extends RegisterSensor implements SelfActing {
    private static final int ADDRESS = 0x02;
    private static final int INTERVAL = 0x40;
    private static final int COMMAND = 0x41;
    private static final int DISTANCES = 0x42;
    private static final int ECHOES = 8;
    private static final int OFF = 0;
    private static final int SINGLE = 1;
    private static final int CONTINUOUS = 2;
    private static final int NOTHING = 255;
    /** Time between pings, nanoseconds: assumption. */
    private static final long PING_NANOS = 50_000_000;
    /** Longest and shortest distance, centimetres. */
    private static final int FARTHEST_CM = 254;
    private static final int NEAREST_CM = 3;
    private static final double NOISE_CM = 0.4;

    private final SoundBeam beam = new SoundBeam();
    private long lastPing = Long.MIN_VALUE;

    NxtUltrasonicSensor(SensorSite site) {
        super(site, ADDRESS, "V1.0", "LEGO", "Sonar");
        powerOff();
    }

    @Override
    void powerOff() {
        setRegister(COMMAND, CONTINUOUS);
        setRegister(INTERVAL, 1);
        for (int i = 0; i < ECHOES; i++) {
            setRegister(DISTANCES + i, NOTHING);
        }
    }

    @Override
    public void afterStep(long nowNanos) {
        long ping = nowNanos / PING_NANOS;
        if (register(COMMAND) == CONTINUOUS && (ping != lastPing || site().ideal())) {
            ping(ping);
        }
    }

    private void ping(long number) {
        lastPing = number;
        double metres = beam.distance(site());
        long centimetres = metres > SoundBeam.REACH ? NOTHING
                : Math.round(metres * 100 + NOISE_CM * site().noise().bell(number, 0));
        setRegister(DISTANCES, (int) (centimetres > FARTHEST_CM ? NOTHING : Math.max(NEAREST_CM, centimetres)));
    }

    @Override
    boolean writable(int register) {
        return register == INTERVAL || register == COMMAND;
    }

    @Override
    void written(int register, long nowNanos) {
        if (register != COMMAND) {
            return;
        }
        if (register(COMMAND) == SINGLE) {
            ping(nowNanos / PING_NANOS);
            setRegister(COMMAND, OFF);
        } else if (register(COMMAND) == CONTINUOUS) {
            ping(nowNanos / PING_NANOS);
        }
    }

    @Override
    Optional<SensorBeam> beam() {
        int centimetres = register(DISTANCES);
        return register(COMMAND) == OFF ? Optional.empty()
                : Optional.of(beam.seen(site(), centimetres == NOTHING ? Double.POSITIVE_INFINITY
                        : centimetres / 100.0));
    }

    /** Distance in centimetres, 255 for nothing. */
    @Override
    double[] reading(long nowNanos) {
        return register(COMMAND) == OFF ? new double[0] : new double[] {register(DISTANCES)};
    }
}
