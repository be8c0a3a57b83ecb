package lejos.hardware.motor;

import java.util.ArrayList;
import java.util.List;
import lejos.hardware.port.BasicMotorPort;
import lejos.hardware.port.TachoMotorPort;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import lejos.utility.Delay;

/**
 * A regulator in software for any {@link TachoMotorPort}; motors use it only if it is given to their constructor.
 *
 * <p>One background thread serves all motors every 4 ms. Unlike the default regulator it slows down to zero before it
 * changes direction, stops the motor to reset the tacho, cannot synchronise motors, and always uses the gains of a
 * large motor. All state of a motor is guarded by the lock of its regulator; listeners are called under it.
 */
public class JavaMotorRegulator implements MotorRegulator {
    private static final int PERIOD_MILLIS = 4;
    private static final int DEFAULT_STALL_ERROR_DEGREES = 50;
    private static final int DEFAULT_STALL_CYCLES = 1000;
    private static final int DEFAULT_ACCELERATION = 6000;
    private static final double SETTLED_DEGREES = 2;
    private static final double SHORTEST_SETTLING_MILLIS = 100;
    private static final double LONGEST_SETTLING_MILLIS = 500;
    private static final TrackingLoop.Gains MOVE = new TrackingLoop.Gains(4, 0.04, 10);
    private static final TrackingLoop.Gains HOLD = new TrackingLoop.Gains(2, 0.02, 8);

    /** Power of the last period in percent. */
    public int power;
    /** Lag in degrees that counts as blocked. */
    protected int stallLimit = DEFAULT_STALL_ERROR_DEGREES;
    /** How many periods the lag must last. */
    protected int stallTime = DEFAULT_STALL_CYCLES;
    /** The port of the motor. */
    protected TachoMotorPort tachoPort;
    /** The thread that serves all motors. */
    protected static final Controller cont = new Controller();

    static {
        Runtime.getRuntime().addShutdownHook(new Thread() {
            @Override
            public void run() {
                cont.floatAll();
            }
        });
    }

    /** A move asked for. */
    private record Move(float speed, int acceleration, int limit, boolean hold) {
        MotionProfile plan(double position, double velocity) {
            if (speed == 0) {
                return MotionProfile.stop(position, velocity, acceleration);
            }
            if (Math.abs(limit) == NO_LIMIT) {
                return MotionProfile.endless(position, velocity, limit > 0 ? speed : -speed, acceleration);
            }
            return MotionProfile.to(limit, position, velocity, speed, acceleration);
        }

        /** Whether the motor can go over to this move without changing direction. */
        boolean continues(double position, double velocity) {
            double length = Math.abs(limit) == NO_LIMIT ? limit : limit - position;
            boolean sameDirection = velocity == 0 || length > 0 == velocity > 0;
            return speed == 0 || sameDirection && Math.abs(length) >= velocity * velocity / (2.0 * acceleration);
        }

        Move withSpeed(float newSpeed) {
            return new Move(newSpeed, acceleration, limit, hold);
        }

        Move withAcceleration(int newAcceleration) {
            return new Move(speed, Math.max(1, newAcceleration), limit, hold);
        }
    }

    private final TrackingLoop loop = new TrackingLoop();
    private MotionProfile plan = MotionProfile.stop(0, 0, 1);
    private double planMillis;
    private double position;
    private double velocity;
    private int encoder;
    private int stallCount;
    private boolean active;
    private boolean moving;
    private boolean stalled;
    private Move current = new Move(0, DEFAULT_ACCELERATION, 0, false);
    /** What follows when the motor has slowed down to zero, or null. */
    private Move next;
    private int limitAngle;
    private RegulatedMotor motor;
    private RegulatedMotorListener listener;
    private boolean startAnnounced;

    /** A regulator for an open port. */
    public JavaMotorRegulator(TachoMotorPort p) {
        tachoPort = p;
        p.setPWMMode(BasicMotorPort.PWM_BRAKE);
        reset();
    }

    @Override
    public int getTachoCount() {
        return tachoPort.getTachoCount();
    }

    /** Stops the motor, lets it float, waits, then makes the count zero. */
    @Override
    public synchronized void resetTachoCount() {
        newMove(0, current.acceleration(), NO_LIMIT, false, true);
        tachoPort.resetTachoCount();
        reset();
    }

    @Override
    public synchronized boolean isMoving() {
        return moving;
    }

    @Override
    public synchronized float getCurrentVelocity() {
        return (float) velocity;
    }

    @Override
    public synchronized void setStallThreshold(int error, int time) {
        stallLimit = error;
        stallTime = time / PERIOD_MILLIS;
    }

    /** Takes the state of motion over and tells the listener: a velocity of 0 ends the move. */
    protected synchronized void updateState(int velocity, boolean hold, boolean stalled) {
        this.stalled = stalled;
        moving = velocity != 0;
        if (!moving && !hold) {
            release();
        }
        announce();
        notifyAll();
    }

    private void announce() {
        if (listener == null || startAnnounced == moving) {
            return;
        }
        startAnnounced = moving;
        if (moving) {
            listener.rotationStarted(motor, getTachoCount(), false, System.currentTimeMillis());
        } else {
            listener.rotationStopped(motor, getTachoCount(), stalled, System.currentTimeMillis());
        }
    }

    private void release() {
        active = false;
        cont.remove(this);
        power = 0;
        tachoPort.controlMotor(0, BasicMotorPort.FLOAT);
    }

    @Override
    public synchronized void addListener(RegulatedMotor motor, RegulatedMotorListener listener) {
        this.motor = motor;
        this.listener = listener;
        startAnnounced = moving;
    }

    @Override
    public synchronized RegulatedMotorListener removeListener() {
        RegulatedMotorListener removed = listener;
        listener = null;
        return removed;
    }

    /** Stops the motor, lets it float and waits; the values are ignored, as in the original. */
    @Override
    public void setControlParamaters(int typ, float moveP, float moveI, float moveD, float holdP, float holdI,
            float holdD, int offset) {
        newMove(0, DEFAULT_ACCELERATION, NO_LIMIT, false, true);
    }

    @Override
    public synchronized void waitComplete() {
        boolean interrupted = false;
        while (moving) {
            try {
                wait();
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public synchronized int getLimitAngle() {
        return limitAngle;
    }

    @Override
    public synchronized boolean isStalled() {
        return stalled;
    }

    /** Makes the model stand where the encoder is. */
    protected synchronized void reset() {
        encoder = tachoPort.getTachoCount();
        rest(encoder);
        loop.reset();
        stallCount = 0;
    }

    private void rest(double at) {
        position = at;
        velocity = 0;
        plan = MotionProfile.stop(at, 0, 1);
        planMillis = 0;
    }

    @Override
    public synchronized float getPosition() {
        if (!active) {
            reset();
        }
        return (float) position;
    }

    @Override
    public synchronized void newMove(float speed, int acceleration, int limit, boolean hold, boolean waitComplete) {
        if (!active) {
            reset();
            active = true;
            cont.add(this);
        }
        limitAngle = limit;
        Move move = new Move(speed, Math.max(1, acceleration), limit, hold);
        if (moving && !move.continues(position, velocity)) {
            begin(new Move(0, move.acceleration(), NO_LIMIT, true));
            next = move;
        } else {
            begin(move);
        }
        if (waitComplete) {
            waitComplete();
        }
    }

    private void begin(Move move) {
        current = move;
        next = null;
        stallCount = 0;
        follow(move);
        if (plan.moves()) {
            updateState(1, true, false);
        } else {
            updateState(0, move.hold(), false);
        }
    }

    private void follow(Move move) {
        plan = move.plan(position, velocity);
        planMillis = 0;
    }

    @Override
    public synchronized void adjustSpeed(float newSpeed) {
        if (adjustable() && newSpeed != current.speed()) {
            current = current.withSpeed(newSpeed);
            follow(current);
        }
    }

    @Override
    public synchronized void adjustAcceleration(int newAcc) {
        if (adjustable() && newAcc != current.acceleration()) {
            current = current.withAcceleration(newAcc);
            follow(current);
        }
    }

    private boolean adjustable() {
        return moving && current.speed() != 0 && !plan.braking(planMillis);
    }

    /** Does nothing: these regulators cannot start together. */
    @Override
    public void startSynchronization() {
        // the original has no synchronisation here either
    }

    /** Does nothing: these regulators cannot start together. */
    @Override
    public void endSynchronization(boolean immReturn) {
        // the original has no synchronisation here either
    }

    /** Does nothing: these regulators cannot start together. */
    @Override
    public void synchronizeWith(MotorRegulator[] rl) {
        // the original has no synchronisation here either
    }

    /** First part of a period. The motor may have been let go of, and its port closed, since the period began. */
    synchronized void readEncoder() {
        if (active) {
            encoder = tachoPort.getTachoCount();
        }
    }

    /**
     * Second part of a period: advances the plan, ends the move if it is complete or blocked, and computes the power.
     */
    synchronized void compute(int elapsedMillis) {
        if (!active) {
            return;
        }
        boolean lagging = Math.abs(position - encoder) > stallLimit;
        stallCount = lagging ? stallCount + 1 : stallCount / 2;
        if (moving) {
            if (stallCount > stallTime) {
                giveUp();
            } else if (!lagging) {
                advance(elapsedMillis);
            }
        }
        if (active) {
            power = loop.power(position - encoder, elapsedMillis, moving ? MOVE : HOLD);
        }
    }

    private void giveUp() {
        next = null;
        rest(encoder);
        updateState(0, current.hold(), true);
    }

    /** While the motor lags too far behind, the plan waits for it: this is not called. */
    private void advance(int elapsedMillis) {
        planMillis += elapsedMillis;
        position = plan.position(planMillis);
        velocity = plan.velocity(planMillis);
        if (!plan.over(planMillis)) {
            return;
        }
        if (next != null) {
            Move following = next;
            updateState(0, true, false);
            begin(following);
            return;
        }
        double settling = planMillis - plan.endMillis();
        boolean there = Math.abs(position - encoder) < SETTLED_DEGREES && settling >= SHORTEST_SETTLING_MILLIS;
        if (there || settling >= LONGEST_SETTLING_MILLIS) {
            updateState(0, current.hold(), false);
        }
    }

    /** Third part of a period. */
    synchronized void writePower() {
        if (active) {
            tachoPort.controlMotor(Math.abs(power), power < 0 ? BasicMotorPort.BACKWARD : BasicMotorPort.FORWARD);
        }
    }

    /**
     * The thread that serves all active motors every 4 ms: reads all encoders, computes all powers, sets all powers.
     */
    protected static class Controller extends Thread {
        /** Guarded by this. */
        private final List<JavaMotorRegulator> motors = new ArrayList<>();
        private boolean running;
        /** When the last period began. Used by the thread itself only. */
        private long lastPeriod;

        /** A thread that starts with the first active motor. */
        protected Controller() {
            super("motor regulation");
            setDaemon(true);
            setPriority(MAX_PRIORITY);
        }

        synchronized void add(JavaMotorRegulator motor) {
            motors.add(motor);
            if (!running) {
                running = true;
                start();
            }
            notifyAll();
        }

        synchronized void remove(JavaMotorRegulator motor) {
            motors.remove(motor);
        }

        synchronized void floatAll() {
            motors.forEach(motor -> motor.tachoPort.controlMotor(0, BasicMotorPort.FLOAT));
        }

        @Override
        public void run() {
            lastPeriod = System.currentTimeMillis();
            try {
                while (true) {
                    List<JavaMotorRegulator> served = awaitMotors();
                    Delay.msDelay(PERIOD_MILLIS);
                    long now = System.currentTimeMillis();
                    int elapsed = (int) Math.max(1, now - lastPeriod);
                    lastPeriod = now;
                    served.forEach(JavaMotorRegulator::readEncoder);
                    served.forEach(motor -> motor.compute(elapsed));
                    served.forEach(JavaMotorRegulator::writePower);
                }
            } catch (InterruptedException e) {
                floatAll();
            }
        }

        private synchronized List<JavaMotorRegulator> awaitMotors() throws InterruptedException {
            while (motors.isEmpty()) {
                wait();
                lastPeriod = System.currentTimeMillis();
            }
            return List.copyOf(motors);
        }
    }
}
