package brickless.device.motor;

import brickless.hardware.MotorRegulation;
import brickless.hardware.MotorSnapshot;
import brickless.hardware.MotorSocket;
import brickless.hardware.MoveRequest;
import brickless.hardware.RegulationState;
import brickless.hardware.RegulationTuning;
import brickless.kernel.Costs;
import brickless.kernel.Processor;
import brickless.physics.Shaft;
import brickless.units.Angles;
import brickless.world.MotorType;

/**
 * An output port: the socket that programs use, the motor plugged into it and its controller.
 *
 * <p>All mutable state is guarded by the lock given to the constructor (the arena), which is never held while charging,
 * blocking or waking.
 */
public final class MotorDevice implements MotorSocket, MotorRegulation {
    /** Period of the control tick, nanoseconds; the tick comes with the first physics step that is due. */
    public static final long CONTROL_NANOS = 4_000_000;
    private static final double NANOS_PER_MILLI = 1e6;
    private static final double FULL_DUTY = 100;
    /** Slower, and driven less, a motor rests: less than friction needs. Assumptions. */
    private static final double RESTING_DEGREES_PER_SECOND = 2;
    private static final double RESTING_DUTY_PERCENT = 5;

    private final int port;
    private final Shaft shaft;
    private final Processor processor;
    private final Processor.Signal standstill;
    private final Object lock;
    private final MotorFitting fitting;
    private final Regulator regulator = new Regulator();
    private MotorType type;
    private DcMotor motor;
    private int zero;
    private long lastTickNanos;

    /**
     * An empty port.
     *
     * @param port 0 to 3 for A to D
     * @param shaft the robot's shaft at this port
     * @param processor charged for calls
     * @param lock guards this port, the arena
     * @param fitting told about expected motors
     */
    public MotorDevice(int port, Shaft shaft, Processor processor, Object lock, MotorFitting fitting) {
        this.port = port;
        this.shaft = shaft;
        this.processor = processor;
        this.standstill = processor.newSignal();
        this.lock = lock;
        this.fitting = fitting;
    }

    /** Port number, 0 to 3 for A to D. */
    public int port() {
        return port;
    }

    /** Plugs a motor in, replacing what was there; null empties the port. */
    public void plug(MotorType newType) {
        synchronized (lock) {
            type = newType;
            motor = null;
            if (newType == null) {
                shaft.unplug();
            } else {
                motor = new DcMotor(newType, shaft);
            }
        }
    }

    /** What is plugged in, null for an empty port. */
    public MotorType type() {
        return type;
    }

    // ---- what programs call ----

    @Override
    public void drive(int dutyPercent) {
        command(Math.max(-100, Math.min(100, dutyPercent)), false);
    }

    @Override
    public void brake() {
        command(0, false);
    }

    @Override
    public void coast() {
        command(0, true);
    }

    private void command(int dutyPercent, boolean open) {
        processor.charge(Costs.MOTOR_COMMAND_NANOS);
        applyDirectly(dutyPercent, open);
    }

    private void applyDirectly(int dutyPercent, boolean open) {
        synchronized (lock) {
            regulator.off();
            setBridge(dutyPercent, open);
        }
        standstill.raise();
    }

    private void setBridge(int dutyPercent, boolean open) {
        if (motor == null) {
            return;
        }
        if (open) {
            motor.coast();
        } else {
            motor.drive(dutyPercent / FULL_DUTY);
        }
    }

    @Override
    public int tachoDegrees() {
        processor.charge(Costs.MOTOR_READ_NANOS);
        synchronized (lock) {
            return encoder();
        }
    }

    @Override
    public void resetTacho() {
        processor.charge(Costs.MOTOR_READ_NANOS);
        synchronized (lock) {
            int shift = encoder();
            zero += shift;
            regulator.shiftFrame(shift);
        }
    }

    @Override
    public MotorRegulation regulation() {
        return this;
    }

    @Override
    public String connected() {
        return type == null ? "none" : type.title();
    }

    @Override
    public void expect(String lejosClass) {
        fitting.expected(this, lejosClass);
    }

    @Override
    public void release() {
        applyDirectly(0, true);
        synchronized (lock) {
            regulator.forget();
        }
    }

    @Override
    public void configure(RegulationTuning tuning) {
        processor.charge(Costs.MOTOR_COMMAND_NANOS);
        synchronized (lock) {
            regulator.configure(tuning);
        }
    }

    @Override
    public void move(MoveRequest request) {
        processor.charge(Costs.MOTOR_COMMAND_NANOS);
        start(request);
    }

    /** Starts a move without charging; for moves of several motors in one command. */
    public void start(MoveRequest request) {
        boolean still;
        long now = processor.nowNanos();
        synchronized (lock) {
            regulator.move(request, encoder(), sinceTickMillis(now));
            still = !regulator.state().moving();
            if (!regulator.drives()) {
                setBridge(0, true);
            }
        }
        if (still) {
            standstill.raise();
        }
    }

    @Override
    public void adjustSpeed(float degreesPerSecond) {
        processor.charge(Costs.MOTOR_COMMAND_NANOS);
        long now = processor.nowNanos();
        synchronized (lock) {
            if (regulator.request() != null) {
                regulator.adjust(degreesPerSecond, regulator.request().accelerationDegreesPerSecondSquared(),
                        sinceTickMillis(now));
            }
        }
    }

    @Override
    public void adjustAcceleration(int degreesPerSecondSquared) {
        processor.charge(Costs.MOTOR_COMMAND_NANOS);
        long now = processor.nowNanos();
        synchronized (lock) {
            if (regulator.request() != null) {
                regulator.adjust(regulator.request().speedDegreesPerSecond(), degreesPerSecondSquared,
                        sinceTickMillis(now));
            }
        }
    }

    @Override
    public void setStallThreshold(int errorDegrees, int timeMillis) {
        synchronized (lock) {
            regulator.setStallThreshold(errorDegrees, timeMillis);
        }
    }

    @Override
    public MotorSnapshot snapshot() {
        processor.charge(Costs.MOTOR_READ_NANOS);
        return observe();
    }

    @Override
    public void awaitStandstill() {
        processor.charge(Costs.MOTOR_READ_NANOS);
        standstill.awaitWhile(this::moving);
    }

    /** Guarded by the lock; the clock is read before it is taken, because a live clock has a lock of its own. */
    private double sinceTickMillis(long nowNanos) {
        return Math.max(0, Math.min(CONTROL_NANOS, nowNanos - lastTickNanos)) / NANOS_PER_MILLI;
    }

    private boolean moving() {
        synchronized (lock) {
            return regulator.state().moving();
        }
    }

    // ---- what the simulation calls ----

    /** State for traces and tests: charges nothing. */
    public MotorSnapshot observe() {
        synchronized (lock) {
            boolean free = !regulator.drives();
            return new MotorSnapshot(regulator.state(), encoder(), free ? encoder() : regulator.positionDegrees(),
                    regulator.velocityDegreesPerSecond());
        }
    }

    /** Encoder in whole degrees, rounded the same way for both directions; charges nothing. */
    public int encoder() {
        return motor == null ? -zero : (int) Math.floor(Angles.degreesFromRadians(shaft.angleRadians()) + 0.5) - zero;
    }

    /** Phase of the controller; charges nothing. */
    public RegulationState state() {
        return regulator.state();
    }

    /** Speed of the motor's shaft at the end of the last step, degrees per second. */
    public double shaftDegreesPerSecond() {
        return Angles.degreesFromRadians(shaft.speedRadiansPerSecond());
    }

    /** Duty of the bridge, −100 to 100; 0 when braking, coasting or empty. */
    public double dutyPercent() {
        return motor == null ? 0 : motor.duty() * FULL_DUTY;
    }

    /** Whether the motor neither turns nor is driven; holding a position without load counts as rest. */
    public boolean rests() {
        return Math.abs(shaftDegreesPerSecond()) < RESTING_DEGREES_PER_SECOND
                && Math.abs(dutyPercent()) < RESTING_DUTY_PERCENT;
    }

    /** Winding current, amperes, signed. */
    public double amperes() {
        return motor == null ? 0 : motor.amperes();
    }

    /** Current taken from the battery, amperes. */
    public double batteryAmperes() {
        return motor == null ? 0 : motor.batteryAmperes();
    }

    /** Runs the controller if its tick is due and puts the motor's torque on the shaft. The caller holds the lock. */
    public void beforeStep(long nowNanos, double volts) {
        if (nowNanos - lastTickNanos >= CONTROL_NANOS) {
            tick((nowNanos - lastTickNanos) / NANOS_PER_MILLI);
            lastTickNanos = nowNanos;
        }
        if (motor != null) {
            motor.beforeStep(volts);
        }
    }

    private void tick(double elapsedMillis) {
        boolean drove = regulator.drives();
        boolean moved = regulator.state().moving();
        int duty = regulator.tick(encoder(), elapsedMillis);
        if (drove) {
            setBridge(duty, !regulator.drives());
        }
        if (moved && !regulator.state().moving()) {
            standstill.raise();
        }
    }
}
