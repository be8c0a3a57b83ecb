package brickless.device.sensor;

import brickless.hardware.AnalogChannel;
import brickless.hardware.I2cChannel;
import brickless.hardware.SensorSocket;
import brickless.hardware.UartChannel;
import brickless.kernel.Processor;
import brickless.physics.RobotBody;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import java.util.Optional;
import java.util.function.Function;

/**
 * An input port: the socket that programs use and the sensor plugged into it.
 *
 * <p>All mutable state is guarded by the arena's monitor, which is never held while charging or blocking.
 */
public final class SensorPortDevice implements SensorSocket {
    private static final int NOTHING_CONNECTED = 126;

    private final int port;
    private final RobotBody robot;
    private final Surroundings surroundings;
    private final RemoteControl remote;
    private final SelfActingSensors selfActing;
    private final Processor processor;
    private final Processor.Signal pause;
    private final SensorFitting fitting;
    private final AnalogPins analog = new AnalogPins(this);
    private final SerialLine uart = new SerialLine(this);
    private final RegisterBus i2c = new RegisterBus(this);
    private SensorModel sensor;

    /**
     * An empty port.
     *
     * @param port 0 to 3 for S1 to S4
     * @param robot that carries the sensors
     * @param surroundings what they perceive
     * @param remote what infrared sensors hear of the remote
     * @param selfActing told about sensors that follow the arena
     * @param processor charged for calls
     * @param fitting told about expected sensors
     */
    public SensorPortDevice(int port, RobotBody robot, Surroundings surroundings, RemoteControl remote,
            SelfActingSensors selfActing, Processor processor, SensorFitting fitting) {
        this.port = port;
        this.robot = robot;
        this.surroundings = surroundings;
        this.remote = remote;
        this.selfActing = selfActing;
        this.processor = processor;
        this.pause = processor.newSignal();
        this.fitting = fitting;
    }

    /** Port number, 0 to 3 for S1 to S4. */
    public int port() {
        return port;
    }

    /**
     * Plugs a sensor in, replacing what was there; null empties the port. The mount's own port number is not looked at.
     */
    public void plug(SensorMount mount) {
        plug(mount, SensorModel::of);
    }

    /** Plugs in the device that {@code device} makes for its place. */
    void plug(SensorMount mount, Function<SensorSite, SensorModel> device) {
        synchronized (lock()) {
            if (sensor != null) {
                sensor.powerOff();
            }
            SensorModel old = sensor;
            sensor = mount == null ? null : device.apply(new SensorSite(robot, mount, surroundings, remote));
            selfActing.replace(old, sensor);
        }
    }

    /** How the plugged sensor is mounted, null for an empty port. */
    public SensorMount mount() {
        return sensor == null ? null : sensor.site().mount();
    }

    /** Kind of the plugged sensor, null for an empty port. */
    public SensorType type() {
        return sensor == null ? null : sensor.type();
    }

    /** Presses a touch sensor by hand, or lets it go. Other sensors do not notice. */
    public void push(boolean pushed) {
        synchronized (lock()) {
            if (sensor != null) {
                sensor.site().setPushed(pushed);
            }
        }
    }

    /**
     * What the sensor sends in its present mode, for traces: 0 or 1, millimetres, degrees, percent, … as listed in
     * MODELS.md; empty while it sends nothing. Charges nothing and changes nothing.
     */
    public double[] reading(long nowNanos) {
        synchronized (lock()) {
            return sensor == null ? new double[0] : sensor.reading(nowNanos);
        }
    }

    /** What a distance sensor reached with its last measurement, for pictures. Charges nothing and changes nothing. */
    public Optional<SensorBeam> beam() {
        synchronized (lock()) {
            return sensor == null ? Optional.empty() : sensor.beam();
        }
    }

    /** What a colour or light sensor looks at, for pictures. Charges nothing and changes nothing. */
    public Optional<SensorSpot> spot() {
        synchronized (lock()) {
            return sensor == null ? Optional.empty() : sensor.spot();
        }
    }

    /** LEGO's name of the mode that {@link #reading} is in, for traces; empty for devices without modes. */
    public String modeName() {
        synchronized (lock()) {
            return sensor == null ? "" : sensor.modeName();
        }
    }

    @Override
    public Wiring wiring() {
        return sensor == null ? Wiring.NONE : sensor.wiring();
    }

    @Override
    public int deviceType() {
        return sensor == null ? NOTHING_CONNECTED : sensor.deviceType();
    }

    @Override
    public String connected() {
        return sensor == null ? "none" : sensor.type().attribute();
    }

    @Override
    public void expect(String lejosClass) {
        fitting.expected(this, lejosClass);
    }

    @Override
    public AnalogChannel analog() {
        return analog;
    }

    @Override
    public UartChannel uart() {
        return uart;
    }

    @Override
    public I2cChannel i2c() {
        return i2c;
    }

    @Override
    public void release() {
        synchronized (lock()) {
            if (sensor != null) {
                sensor.powerOff();
            }
        }
    }

    // ---- for the channels ----

    Object lock() {
        return surroundings.arena();
    }

    SensorModel sensor() {
        return sensor;
    }

    /** The time; not to be asked under the lock, because a live clock has a lock of its own. */
    long nowNanos() {
        return processor.nowNanos();
    }

    void charge(long nanos) {
        processor.charge(nanos);
    }

    /** Blocks the calling program thread for some time; ideal sensors make nobody wait. */
    void pause(long nanos) {
        if (!surroundings.ideal()) {
            pause.await(nanos);
        }
    }

    /** Blocks the calling program thread for some time, ideal or not. */
    void occupy(long nanos) {
        pause.await(nanos);
    }
}
