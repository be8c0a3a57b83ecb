package brickless.device.motor;

import brickless.hardware.MotorRegulation;
import brickless.hardware.MoveRequest;
import brickless.hardware.RegulationState;
import brickless.hardware.RegulationTuning;

/**
 * The controller of one motor without its clock: told the encoder in each control tick, it answers with a duty. Degrees
 * are those of the hardware frame.
 *
 * <p>Guarded by the arena's monitor.
 */
final class Regulator {
    /**
     * At the end of a move the controller waits at least and at most this long for the motor to settle, milliseconds.
     */
    private static final double SETTLE_AT_LEAST = 100;
    private static final double SETTLE_AT_MOST = 500;
    /** Close enough to the target, degrees. */
    private static final double SETTLED = 2;

    private final TrackingLoop loop = new TrackingLoop();
    private RegulationState state = RegulationState.IDLE;
    private MovePlan plan = MovePlan.rest(0);
    private MoveRequest request;
    private double planMillis;
    private float position;
    private float velocity;
    private boolean holding;
    private int stallDegrees;
    private int stallMillis;
    private int nextStallDegrees;
    private int nextStallMillis;
    private double laggingMillis;

    Regulator() {
        forget();
    }

    /** Back to the settings of a fresh port, not driving. */
    void forget() {
        loop.configure(new RegulationTuning(4, 0.04f, 10, 2, 0.02f, 8, 0));
        nextStallDegrees = 50;
        nextStallMillis = 1000;
        off();
    }

    void configure(RegulationTuning tuning) {
        loop.configure(tuning);
    }

    void setStallThreshold(int degrees, int millis) {
        nextStallDegrees = degrees;
        nextStallMillis = millis;
    }

    /** Ends regulation: the model follows the encoder again. */
    void off() {
        state = RegulationState.IDLE;
        holding = false;
        velocity = 0;
        loop.reset();
    }

    /** Whether the controller decides the duty. */
    boolean drives() {
        return state.moving() || holding;
    }

    /**
     * Starts a move.
     *
     * @param newRequest what is wanted
     * @param encoder present count
     * @param sinceTickMillis time since the last control tick: the move counts from now, not from a tick, so that
     *         motors started one after the other stay together
     */
    void move(MoveRequest newRequest, int encoder, double sinceTickMillis) {
        if (!drives()) {
            position = encoder;
            velocity = 0;
        } else if (state.moving() && laggingMillis == 0) {
            position = plan.position(Math.max(0, planMillis + sinceTickMillis));
            velocity = plan.velocity(Math.max(0, planMillis + sinceTickMillis));
        }
        request = newRequest;
        replan(newRequest);
        planMillis = -sinceTickMillis;
        if (plan.empty()) {
            finish(newRequest.hold());
        } else {
            state = RegulationState.START;
        }
    }

    private void replan(MoveRequest newRequest) {
        plan = MovePlan.of(newRequest, position, velocity);
        stallDegrees = nextStallDegrees;
        stallMillis = nextStallMillis;
        laggingMillis = 0;
    }

    /** Changes speed or acceleration of the running move; ignored in the final deceleration and at rest. */
    void adjust(float speed, int acceleration, double sinceTickMillis) {
        boolean running = state == RegulationState.START || state == RegulationState.ACCEL
                || state == RegulationState.MOVE;
        boolean same = running && request.speedDegreesPerSecond() == speed
                && request.accelerationDegreesPerSecondSquared() == acceleration;
        if (running && !same && request.speedDegreesPerSecond() != 0) {
            move(new MoveRequest(speed, acceleration, request.limitDegrees(), request.hold()), 0, sinceTickMillis);
        }
    }

    /** The last request; null before the first. */
    MoveRequest request() {
        return request;
    }

    /**
     * One control tick.
     *
     * @return duty in percent; meaningless if {@link #drives()} is false afterwards
     */
    int tick(int encoder, double elapsedMillis) {
        if (!drives()) {
            position = encoder;
            return 0;
        }
        if (state.moving()) {
            advance(encoder, elapsedMillis);
        }
        if (!drives()) {
            return 0;
        }
        return loop.duty(position - encoder, !state.moving(), elapsedMillis);
    }

    private void advance(int encoder, double elapsedMillis) {
        if (Math.abs(position - encoder) > stallDegrees) {
            laggingMillis += elapsedMillis;
            if (laggingMillis > stallMillis) {
                stall(encoder);
                return;
            }
        } else {
            laggingMillis = laggingMillis < elapsedMillis ? 0 : laggingMillis / 2;
            planMillis += elapsedMillis;
        }
        position = plan.position(Math.max(0, planMillis));
        velocity = plan.velocity(Math.max(0, planMillis));
        state = phase();
        double settling = planMillis - plan.endMillis();
        if (settling >= SETTLE_AT_LEAST && Math.abs(position - encoder) < SETTLED || settling >= SETTLE_AT_MOST) {
            finish(request.hold());
        }
    }

    private RegulationState phase() {
        if (planMillis < plan.cruiseMillis()) {
            return RegulationState.ACCEL;
        }
        return planMillis < plan.brakingMillis() ? RegulationState.MOVE : RegulationState.DECEL;
    }

    private void stall(int encoder) {
        position = encoder;
        velocity = 0;
        loop.reset();
        state = RegulationState.STALL;
        holding = request.hold();
    }

    private void finish(boolean hold) {
        velocity = 0;
        position = plan.target();
        holding = hold;
        state = hold ? RegulationState.HOLD : RegulationState.IDLE;
        if (!hold) {
            loop.reset();
        }
    }

    /** Moves the origin of the hardware frame: what was {@code degrees} becomes 0. */
    void shiftFrame(int degrees) {
        plan.shift(degrees);
        position -= degrees;
        if (request != null && Math.abs((long) request.limitDegrees()) != MotorRegulation.NO_LIMIT) {
            request = new MoveRequest(request.speedDegreesPerSecond(), request.accelerationDegreesPerSecondSquared(),
                    request.limitDegrees() - degrees, request.hold());
        }
    }

    RegulationState state() {
        return state;
    }

    float positionDegrees() {
        return position;
    }

    float velocityDegreesPerSecond() {
        return velocity;
    }
}
