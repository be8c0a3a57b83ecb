package brickless.device.sensor;

import brickless.physics.Aim;
import brickless.physics.SoundField;
import brickless.units.Angles;
import java.util.Optional;

/** EV3 ultrasonic sensor: distance in millimetres, a new one with every ping, each known one ping later. */
final class UltrasonicSensor extends UartSensor implements SoundField.Source, SelfActing {
    private static final int DEVICE = 30;
    /** Time between pings, nanoseconds: assumption within 25 to 50 ms. */
    static final long PING_NANOS = 25_000_000;
    /** Shortest distance that can be told, millimetres. */
    static final int NEAREST_MM = 30;
    /** What the sensor reports for nothing, millimetres. */
    static final int NOTHING_MM = 2550;
    /** Standard deviation of a distance, millimetres; the accuracy is ±1 cm. */
    private static final double NOISE_MM = 3;
    private static final double MM_PER_TENTH_INCH = 2.54;
    private static final int INCHES = 1;
    private static final int LISTEN = 2;
    private static final int SINGLE = 3;
    private static final int SINGLE_INCHES = 4;
    private static final int CONTINUOUS_INCHES = 6;
    /** Pings are heard within this angle of the sender's direction, radians: assumption. */
    private static final double HEARD_WITHIN = Angles.radiansFromDegrees(45);

    private final SoundBeam beam = new SoundBeam();
    private final boolean ideal;
    private int onItsWay = NOTHING_MM;
    private int latest = NOTHING_MM;
    private long lastPing = Long.MIN_VALUE;

    UltrasonicSensor(SensorSite site) {
        super(site, DEVICE, UartMode.slow("US-DIST-CM", 1, 2), UartMode.slow("US-DIST-IN", 1, 2),
                UartMode.slow("US-LISTEN", 1, 1),
                UartMode.slow("US-SI-CM", 1, 2), UartMode.slow("US-SI-IN", 1, 2), UartMode.slow("US-DC-CM", 1, 2),
                        UartMode.slow("US-DC-IN", 1, 2));
        ideal = site.ideal();
    }

    private SoundField sound() {
        return site().surroundings().arena().sound();
    }

    private boolean pinging() {
        return mode() != DARK && mode() != LISTEN && mode() != SINGLE && mode() != SINGLE_INCHES;
    }

    @Override
    void selected(long nowNanos) {
        sound().remove(this);
        if (mode() == DARK || mode() == LISTEN) {
            return;
        }
        ping(nowNanos / PING_NANOS);
        latest = onItsWay;
        if (pinging()) {
            sound().add(this);
        }
    }

    @Override
    public void afterStep(long nowNanos) {
        long ping = nowNanos / PING_NANOS;
        if (!pinging() || ping == lastPing && !ideal) {
            return;
        }
        int echo = onItsWay;
        ping(ping);
        latest = ideal ? onItsWay : echo;
    }

    private void ping(long number) {
        lastPing = number;
        double metres = beam.distance(site());
        if (metres > SoundBeam.REACH) {
            onItsWay = NOTHING_MM;
            return;
        }
        long millimetres = Math.round(metres * 1000 + NOISE_MM * site().noise().bell(number, 0));
        onItsWay = (int) Math.max(NEAREST_MM, Math.min(NOTHING_MM, millimetres));
    }

    @Override
    Optional<SensorBeam> beam() {
        return mode() == DARK || mode() == LISTEN ? Optional.empty()
                : Optional.of(beam.seen(site(), latest == NOTHING_MM ? Double.POSITIVE_INFINITY : latest / 1000.0));
    }

    /** Whether this sensor's pings arrive somewhere. */
    @Override
    public boolean reaches(Aim other) {
        Aim own = aim();
        double dx = other.x - own.x;
        double dy = other.y - own.y;
        double off = StrictMath.IEEEremainder(StrictMath.atan2(dy, dx) - own.headingRadians, 2 * StrictMath.PI);
        return dx * dx + dy * dy <= SoundBeam.REACH * SoundBeam.REACH && Math.abs(off) <= HEARD_WITHIN;
    }

    @Override
    void message(long nowNanos, byte[] out) {
        switch (mode()) {
            case LISTEN -> out[0] = (byte) (sound().heard(this, aim()) ? 1 : 0);
            case INCHES, SINGLE_INCHES,
                    CONTINUOUS_INCHES -> putShort(out, 0, (int) Math.round(latest / MM_PER_TENTH_INCH));
            default -> putShort(out, 0, latest);
        }
    }
}
