package brickless.device.sensor;

import java.util.Arrays;

/**
 * The sensors of one robot that follow the arena of their own accord; the others cost nothing in a step. Guarded by the
 * arena's monitor.
 */
public final class SelfActingSensors {
    private static final SelfActing[] NONE = {};

    private SelfActing[] sensors = NONE;

    /** A sensor was plugged in in place of another; both may be null. */
    void replace(SensorModel old, SensorModel plugged) {
        sensors = Arrays.stream(sensors).filter(sensor -> sensor != old).toArray(SelfActing[]::new);
        if (plugged instanceof SelfActing acting) {
            sensors = Arrays.copyOf(sensors, sensors.length + 1);
            sensors[sensors.length - 1] = acting;
        }
    }

    /** Follows the arena; called after every step, the caller holds the arena's monitor. */
    public void afterStep(long nowNanos) {
        for (SelfActing sensor : sensors) {
            sensor.afterStep(nowNanos);
        }
    }
}
