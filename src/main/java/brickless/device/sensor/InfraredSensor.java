package brickless.device.sensor;

import brickless.physics.Aim;
import brickless.physics.ObstacleBody;
import brickless.physics.RayFan;
import brickless.physics.RayHit;
import brickless.units.Angles;
import brickless.world.Beacon;
import brickless.world.Rgb;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** EV3 infrared sensor: proximity, beacons and remote. */
final class InfraredSensor extends UartSensor implements RayFan.Visitor, SelfActing {
    private static final int DEVICE = 33;
    /** Time between measurements, nanoseconds: assumption within 50 to 60 ms. */
    static final long PERIOD_NANOS = 50_000_000;
    private static final int CHANNELS = 4;
    private static final int PROXIMITY = 0;
    private static final int SEEK = 1;
    private static final int REMOTE = 2;
    /** Proximity 100, metres. */
    private static final double PROXIMITY_REACH = 0.70;
    /** Seek distance 100, metres. */
    private static final double SEEK_REACH = 2.0;
    /** Half the opening angle of the proximity beam, radians: assumption. */
    private static final double BEAM = Angles.radiansFromDegrees(10);
    private static final int RAYS = 5;
    /** Black things seem this much further away than white ones: assumption. */
    private static final double BLACK_FACTOR = 1.25;
    /** Bearing that reads 25, and the largest at which beacons are seen, radians: assumption. */
    private static final double FULL_BEARING = Angles.radiansFromDegrees(60);
    private static final double WIDEST_BEARING = Angles.radiansFromDegrees(100);
    private static final int LARGEST_HEADING = 25;
    private static final byte NO_BEACON = (byte) 128;
    private static final double NOISE = 0.5;

    private final RayFan fan = new RayFan(BEAM, RAYS, PROXIMITY_REACH);
    private final RayHit hit = new RayHit();
    private double nearest;
    private final byte[] seek = new byte[2 * CHANNELS];
    private int proximity = 100;
    private long lastUpdate = Long.MIN_VALUE;

    InfraredSensor(SensorSite site) {
        super(site, DEVICE, UartMode.slow("IR-PROX", 1, 1), UartMode.slow("IR-SEEK", 8, 1),
                UartMode.slow("IR-REMOTE", 4, 1),
                UartMode.slow("IR-REM-A", 1, 2), UartMode.slow("IR-S-ALT", 4, 1), UartMode.slow("IR-CAL", 2, 2));
    }

    @Override
    void selected(long nowNanos) {
        if (mode() != DARK) {
            measure(nowNanos / PERIOD_NANOS);
        }
    }

    @Override
    public void afterStep(long nowNanos) {
        long update = nowNanos / PERIOD_NANOS;
        if (mode() != DARK && (update != lastUpdate || site().ideal())) {
            measure(update);
        }
    }

    private void measure(long update) {
        lastUpdate = update;
        if (mode() == PROXIMITY) {
            proximity = proximity(update);
        } else if (mode() == SEEK) {
            seek(update);
        }
    }

    private int proximity(long update) {
        nearest = Double.POSITIVE_INFINITY;
        site().cast(fan, this);
        if (nearest > PROXIMITY_REACH) {
            return 100;
        }
        return (int) Math.max(0,
                Math.min(100, Math.round(100 * nearest / PROXIMITY_REACH + NOISE * site().noise().bell(update, 0))));
    }

    @Override
    public void met(RayHit thing) {
        nearest = Math.min(nearest, thing.distanceMetres() * darkness(thing));
    }

    private static double darkness(RayHit thing) {
        if (thing.solid() instanceof ObstacleBody obstacle) {
            Rgb c = obstacle.description().colour();
            return BLACK_FACTOR - (BLACK_FACTOR - 1) * (c.red() + c.green() + c.blue()) / (3 * 255.0);
        }
        return 1;
    }

    private void seek(long update) {
        for (int channel = 0; channel < CHANNELS; channel++) {
            seek[2 * channel] = 0;
            seek[2 * channel + 1] = NO_BEACON;
        }
        for (Beacon beacon : site().surroundings().arena().description().beacons()) {
            seek(beacon, update);
        }
    }

    private void seek(Beacon beacon, long update) {
        Aim aim = aim();
        double dx = beacon.position().x() - aim.x;
        double dy = beacon.position().y() - aim.y;
        double distance = StrictMath.sqrt(dx * dx + dy * dy);
        double bearing = StrictMath.IEEEremainder(StrictMath.atan2(dy, dx) - aim.headingRadians, 2 * StrictMath.PI);
        if (distance > SEEK_REACH || Math.abs(bearing) > WIDEST_BEARING || hidden(bearing, distance, beacon)) {
            return;
        }
        int lane = 1 + beacon.channel();
        long heading = Math.round(LARGEST_HEADING * bearing / FULL_BEARING + NOISE * site().noise().bell(update, lane));
        long range = Math.round(100 * distance / SEEK_REACH + NOISE * site().noise().bell(update, lane + CHANNELS));
        int at = 2 * (beacon.channel() - 1);
        seek[at] = (byte) Math.max(-LARGEST_HEADING, Math.min(LARGEST_HEADING, heading));
        seek[at + 1] = (byte) Math.max(0, Math.min(100, range));
    }

    @Override
    Optional<SensorBeam> beam() {
        return switch (mode()) {
            case PROXIMITY -> Optional.of(SensorBeam.of(aim(), fan.turnsRadians(), fan.lengthsMetres(),
                    proximity == 100 ? Double.POSITIVE_INFINITY : proximity * PROXIMITY_REACH / 100));
            case SEEK -> Optional.of(towardsBeacons());
            default -> Optional.empty();
        };
    }

    /** A ray towards each beacon that is seen, as bearing and distance tell. */
    private SensorBeam towardsBeacons() {
        int[] seen = IntStream.range(0, CHANNELS).filter(channel -> seek[2 * channel + 1] != NO_BEACON).toArray();
        double[] turns = IntStream.of(seen)
                .mapToDouble(channel -> seek[2 * channel] * FULL_BEARING / LARGEST_HEADING).toArray();
        double[] lengths = IntStream.of(seen)
                .mapToDouble(channel -> seek[2 * channel + 1] * SEEK_REACH / 100).toArray();
        return SensorBeam.of(aim(), turns, lengths, DoubleStream.of(lengths).min().orElse(Double.POSITIVE_INFINITY));
    }

    /** Whether something stands in front of a beacon; the obstacle in which the beacon itself is does not count. */
    private boolean hidden(double bearing, double distance, Beacon beacon) {
        site().surroundings().ray(aim(), bearing, distance, site(), hit);
        return hit.solid() != null && !hit.solid().name().equals(beacon.id()) && hit.distanceMetres() < distance;
    }

    @Override
    void message(long nowNanos, byte[] out) {
        switch (mode()) {
            case PROXIMITY -> out[0] = (byte) proximity;
            case SEEK -> System.arraycopy(seek, 0, out, 0, seek.length);
            case REMOTE -> {
                for (int channel = 0; channel < CHANNELS; channel++) {
                    out[channel] = (byte) site().remote().code(channel);
                }
            }
            default -> Arrays.fill(out, 0, mode(mode()).bytes(), (byte) 0);
        }
    }
}
