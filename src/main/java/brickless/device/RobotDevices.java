package brickless.device;

import brickless.device.battery.Battery;
import brickless.device.motor.MotorDevice;
import brickless.device.motor.MotorFitting;
import brickless.device.sensor.FloorColour;
import brickless.device.sensor.RemoteControl;
import brickless.device.sensor.SelfActingSensors;
import brickless.device.sensor.SensorFitting;
import brickless.device.sensor.SensorPortDevice;
import brickless.device.sensor.Surroundings;
import brickless.hardware.MoveRequest;
import brickless.kernel.Costs;
import brickless.kernel.Processor;
import brickless.physics.Arena;
import brickless.physics.RobotBody;
import brickless.world.RobotModel;
import java.util.Arrays;

/**
 * Motors, sensors and battery of one robot, as drawn in its model.
 *
 * <p>The simulation calls {@link #beforeStep} of all robots, then {@link brickless.physics.Arena#step}, then {@link
 * #afterStep} of all robots, holding the arena's monitor throughout. Neither allocates.
 */
public final class RobotDevices {
    private static final int PORTS = 4;

    private final Processor processor;
    private final Arena arena;
    private final Battery battery = new Battery();
    private final RemoteControl remote = new RemoteControl();
    private final MotorDevice[] motors = new MotorDevice[PORTS];
    private final SelfActingSensors selfActing = new SelfActingSensors();
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
        this.arena = surroundings.arena();
        Arrays.setAll(motors, port -> new MotorDevice(port, robot.shaft(port), processor, arena, motorFitting));
        Arrays.setAll(sensors,
                port -> new SensorPortDevice(port, robot, surroundings, remote, selfActing, processor, sensorFitting));
        RobotModel model = robot.model();
        model.wheels().forEach(wheel -> motors[wheel.port()].plug(wheel.motor()));
        model.turrets().forEach(turret -> motors[turret.port()].plug(turret.motor()));
        model.claws().forEach(claw -> motors[claw.port()].plug(claw.motor()));
        model.sensors().forEach(mount -> sensors[mount.port()].plug(mount));
    }

    /** The devices of a robot as drawn, with nothing plugged in at run time. */
    public static RobotDevices of(Arena arena, RobotBody robot, Processor processor, long seed, boolean ideal) {
        Surroundings surroundings = new Surroundings(arena, FloorColour.of(arena.description()), seed, ideal);
        return new RobotDevices(robot, surroundings, processor, MotorFitting.FIXED, SensorFitting.FIXED);
    }

    /** Output port 0 to 3. */
    public MotorDevice motor(int port) {
        return motors[port];
    }

    /** Whether no motor turns or is driven. */
    public boolean motorsRest() {
        for (MotorDevice motor : motors) {
            if (!motor.rests()) {
                return false;
            }
        }
        return true;
    }

    /** Input port 0 to 3. */
    public SensorPortDevice sensor(int port) {
        return sensors[port];
    }

    /** The battery. */
    public Battery battery() {
        return battery;
    }

    /** Presses buttons of the infrared remote: channel 1 to 4, code 0 (none) to 11 as leJOS numbers them. */
    public void remote(int channel, int code) {
        remote.press(channel, code);
    }

    /** Sets how loud it is in the arena, decibels; 0 leaves the background noise. */
    public void soundLevel(double decibels) {
        arena.sound().setDecibels(decibels);
    }

    /**
     * Starts several regulated moves in one command and one control tick, see {@link
     * brickless.hardware.BrickHardware#moveTogether}.
     */
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

    /** The program is over: motors coast and sensors fall silent, as when the brick's drivers are closed. */
    public void powerOff() {
        for (MotorDevice motor : motors) {
            motor.release();
        }
        for (SensorPortDevice sensor : sensors) {
            sensor.release();
        }
    }

    /** Sensors follow the arena; {@code nowNanos} is the time after the step. */
    public void afterStep(long nowNanos) {
        selfActing.afterStep(nowNanos);
    }
}
