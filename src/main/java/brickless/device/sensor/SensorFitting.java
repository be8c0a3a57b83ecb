package brickless.device.sensor;

/** Told which leJOS sensor class is about to use a port, so that an automatically fitted robot can plug a sensor in. */
@FunctionalInterface
public interface SensorFitting {
    /** Does nothing: the robot stays as drawn. */
    SensorFitting FIXED = (device, lejosClass) -> {};

    /** May call {@link SensorPortDevice#plug}. */
    void expected(SensorPortDevice device, String lejosClass);
}
