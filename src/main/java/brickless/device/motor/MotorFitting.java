package brickless.device.motor;

/** Told which leJOS motor class is about to use a port, so that an automatically fitted robot can plug a motor in. */
@FunctionalInterface
public interface MotorFitting {
    /** Does nothing: the robot stays as drawn. */
    MotorFitting FIXED = (device, lejosClass) -> {};

    /** May call {@link MotorDevice#plug}. */
    void expected(MotorDevice device, String lejosClass);
}
