package brickless.device;

import brickless.device.battery.Battery;
import brickless.device.motor.MotorDevice;
import brickless.device.motor.MotorFitting;
import brickless.device.sensor.RemoteControl;
import brickless.device.sensor.SensorFitting;
import brickless.device.sensor.SensorPortDevice;
import brickless.device.sensor.Surroundings;
import brickless.hardware.MoveRequest;
import brickless.kernel.Costs;
import brickless.kernel.Processor;
import brickless.physics.RobotBody;
import brickless.world.RobotModel;
import java.util.Arrays;

/**
 * Motors, sensors and battery of one robot, as drawn in its model.
 *
 * <p>The simulation calls {@link #beforeStep} of all robots, then {@link brickless.physics.Arena#step}, then {@link #afterStep} of all robots, holding the
 * arena's monitor throughout. Neither allocates.
 */
public final class RobotDevices {
    private static final int PORTS = 4;

    private final Processor processor;
    private final Object lock;
    private final Battery battery = new Battery();
    private final RemoteControl remote = new RemoteControl();
    private final MotorDevice[] motors = new MotorDevice[PORTS];
    private final SensorPortDevice[] sensors = new SensorPortDevice[PORTS];

    /**
     * Plugs everything in that the robot's model names.
     *
     * @param robot in the arena
     * @param surroundings shared by all robots
     * @param processor of the robot's program
     * @param motorFitting told about motors that programs expect
     * @param sensorFitting told about sensors that programs expect
     */
    public RobotDevices(RobotBody robot, Surroundings surroundings, Processor processor, MotorFitting motorFitting,
            SensorFitting sensorFitting) {
        this.processor = processor;
        this.lock = surroundings.arena();
        Arrays.setAll(motors, port -> new MotorDevice(port, robot.shaft(port), processor, lock, motorFitting));
        Arrays.setAll(sensors, port -> new SensorPortDevice(port, robot, surroundings, remote, processor, sensorFitting));
        RobotModel model = robot.model();
        model.wheels().forEach(wheel -> motors[wheel.port()].plug(wheel.motor()));
        model.turrets().forEach(turret -> motors[turret.port()].plug(turret.motor()));
        model.claws().forEach(claw -> motors[claw.port()].plug(claw.motor()));
        model.sensors().forEach(mount -> sensors[mount.port()].plug(mount));
    }

    /** Output port 0 to 3. */
    public MotorDevice motor(int port) {
        return motors[port];
    }

    /** Input port 0 to 3. */
    public SensorPortDevice sensor(int port) {
        return sensors[port];
    }

    /** The battery. */
    public Battery battery() {
        return battery;
    }

    /** The infrared remote pointed at this robot. */
    public RemoteControl remote() {
        return remote;
    }

    /** Starts several regulated moves in one command and one control tick, see {@link brickless.hardware.BrickHardware#moveTogether}. */
    public void moveTogether(int[] ports, MoveRequest[] requests) {
        processor.charge(Costs.MOTOR_COMMAND_NANOS);
        for (int i = 0; i < ports.length; i++) {
            motors[ports[i]].start(requests[i]);
        }
    }

    /** Motor controllers, battery, torques: from the requests of the program to the coming step. */
    public void beforeStep(long nowNanos) {
        double volts = battery.terminalVolts();
        double inMotors = 0;
        double fromBattery = 0;
        for (MotorDevice motor : motors) {
            motor.beforeStep(nowNanos, volts);
            inMotors += Math.abs(motor.amperes());
            fromBattery += motor.batteryAmperes();
        }
        battery.load(inMotors, fromBattery);
    }

    /** Sensors follow the arena; {@code nowNanos} is the time after the step. */
    public void afterStep(long nowNanos) {
        for (SensorPortDevice sensor : sensors) {
            sensor.afterStep(nowNanos);
        }
    }
}
