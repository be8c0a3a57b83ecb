package brickless.trace;

import brickless.world.Pose2;
import java.util.List;

/**
 * One robot at one instant.
 *
 * @param name name of the robot in its world
 * @param pose where its origin is
 * @param motors plugged motors, by port
 * @param sensors plugged sensors, by port
 * @param batteryVolts voltage at the battery's terminals
 */
public record RobotSample(String name, Pose2 pose, List<MotorSample> motors, List<SensorSample> sensors,
        double batteryVolts) {
    public RobotSample {
        motors = List.copyOf(motors);
        sensors = List.copyOf(sensors);
    }

    /**
     * A motor.
     *
     * @param port letter A to D
     * @param tachoDegrees encoder
     * @param degreesPerSecond speed of the motor's shaft
     * @param dutyPercent applied duty, −100 to 100
     * @param amperes current drawn
     */
    public record MotorSample(char port, double tachoDegrees, double degreesPerSecond, double dutyPercent,
            double amperes) {}

    /**
     * A sensor.
     *
     * @param port number 1 to 4
     * @param kind name in the vocabulary of robot files
     * @param values what it measures now in its present mode, in the device's own units; empty while it sends nothing
     */
    public record SensorSample(int port, String kind, double[] values) {}
}
