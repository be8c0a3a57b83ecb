package brickless.hardware.fake;

import brickless.hardware.MotorRegulation;
import brickless.hardware.MotorSnapshot;
import brickless.hardware.MotorSocket;
import brickless.hardware.MoveRequest;
import brickless.hardware.RegulationState;
import brickless.hardware.RegulationTuning;
import java.util.ArrayList;
import java.util.List;

/**
 * A motor that follows every plan exactly, unless it is blocked. Plans are ramps integrated millisecond by millisecond;
 * a move ends 100 ms after the reference stands. Safe for use by several threads.
 */
public final class FakeMotor implements MotorSocket, MotorRegulation {
    private static final int SETTLING_MILLIS = 100;
    private static final int PATIENCE_MILLIS = 60_000;

    private final FakeBrick brick;
    private final List<String> log = new ArrayList<>();
    private final List<MoveRequest> moves = new ArrayList<>();
    private RegulationTuning tuning;
    private MoveRequest request = new MoveRequest(0, 6000, NO_LIMIT, false);
    private RegulationState state = RegulationState.IDLE;
    private double position;
    private double velocity;
    private double encoder;
    private int settledMillis;
    private int stalledMillis;
    private int stallError = 50;
    private int stallTime = 1000;
    private boolean blocked;
    private Runnable whileWaiting = () -> {};

    FakeMotor(FakeBrick brick) {
        this.brick = brick;
    }

    /**
     * Everything that was done to the socket, in order, e.g. {@code "drive 50"}, {@code "expect NXTRegulatedMotor"}.
     */
    public synchronized List<String> log() {
        return List.copyOf(log);
    }

    /** All moves so far. */
    public synchronized List<MoveRequest> moves() {
        return List.copyOf(moves);
    }

    /** The last move. */
    public synchronized MoveRequest lastMove() {
        return moves.get(moves.size() - 1);
    }

    /** The constants set last, null before. */
    public synchronized RegulationTuning tuning() {
        return tuning;
    }

    /** Blocks or frees the axle. */
    public synchronized void block(boolean nowBlocked) {
        blocked = nowBlocked;
    }

    /** Turns the axle by hand; a coasting motor's model follows. */
    public synchronized void turnByHand(double degrees) {
        encoder += degrees;
        if (state == RegulationState.IDLE) {
            position = encoder;
        }
    }

    /** Something to happen once when a program thread waits for standstill. */
    public synchronized void whileWaiting(Runnable action) {
        whileWaiting = action;
    }

    synchronized void millisecond() {
        notifyAll();
        if (!state.moving()) {
            return;
        }
        boolean lagging = Math.abs(position - encoder) > stallError;
        stalledMillis = lagging ? stalledMillis + 1 : 0;
        if (stalledMillis > stallTime) {
            state = RegulationState.STALL;
            position = encoder;
            velocity = 0;
            return;
        }
        if (!lagging) {
            follow();
        }
        if (!blocked) {
            encoder = position;
        }
    }

    private void follow() {
        double step = request.accelerationDegreesPerSecondSquared() / 1000.0;
        double target = wantedVelocity();
        double change = Math.max(-step, Math.min(step, target - velocity));
        velocity += change;
        position += (velocity - change / 2) / 1000.0;
        if (limited() && arrived(step)) {
            position = request.limitDegrees();
            velocity = 0;
        }
        boolean there = request.speedDegreesPerSecond() == 0 || limited() && position == request.limitDegrees();
        boolean standing = velocity == 0 && there;
        settledMillis = standing ? settledMillis + 1 : 0;
        if (settledMillis >= SETTLING_MILLIS) {
            state = request.hold() ? RegulationState.HOLD : RegulationState.IDLE;
        } else {
            boolean cruising = change == 0;
            RegulationState ahead = cruising ? RegulationState.MOVE : RegulationState.ACCEL;
            state = standing || braking(target) ? RegulationState.DECEL : ahead;
        }
    }

    private boolean arrived(double step) {
        double way = Math.abs(request.limitDegrees() - position);
        return way <= Math.abs(velocity) / 1000.0 + 0.01 && Math.abs(velocity) < 20 * step;
    }

    private boolean braking(double target) {
        return Math.abs(target) < request.speedDegreesPerSecond() || request.speedDegreesPerSecond() == 0;
    }

    private double wantedVelocity() {
        if (!limited()) {
            return request.limitDegrees() > 0 ? request.speedDegreesPerSecond() : -request.speedDegreesPerSecond();
        }
        double way = request.limitDegrees() - position;
        double braking = Math.sqrt(2.0 * request.accelerationDegreesPerSecondSquared() * Math.abs(way));
        return Math.copySign(Math.min(request.speedDegreesPerSecond(), braking), way);
    }

    private boolean limited() {
        return request.speedDegreesPerSecond() != 0 && Math.abs(request.limitDegrees()) != NO_LIMIT;
    }

    @Override
    public synchronized void drive(int dutyPercent) {
        log.add("drive " + dutyPercent);
        state = RegulationState.IDLE;
    }

    @Override
    public synchronized void brake() {
        log.add("brake");
        state = RegulationState.IDLE;
    }

    @Override
    public synchronized void coast() {
        log.add("coast");
        state = RegulationState.IDLE;
    }

    @Override
    public synchronized int tachoDegrees() {
        return (int) Math.round(encoder);
    }

    @Override
    public synchronized void resetTacho() {
        log.add("resetTacho");
        position -= encoder;
        encoder = 0;
    }

    @Override
    public MotorRegulation regulation() {
        return this;
    }

    @Override
    public String connected() {
        return "ev3-large";
    }

    @Override
    public synchronized void expect(String lejosClass) {
        log.add("expect " + lejosClass);
    }

    @Override
    public synchronized void release() {
        log.add("release");
        state = RegulationState.IDLE;
        velocity = 0;
        stallError = 50;
        stallTime = 1000;
    }

    @Override
    public synchronized void configure(RegulationTuning newTuning) {
        tuning = newTuning;
    }

    @Override
    public synchronized void move(MoveRequest newRequest) {
        moves.add(newRequest);
        start(newRequest);
    }

    private void start(MoveRequest newRequest) {
        request = newRequest;
        settledMillis = 0;
        stalledMillis = 0;
        boolean there = newRequest.speedDegreesPerSecond() == 0 || limited() && position == newRequest.limitDegrees();
        boolean empty = velocity == 0 && there;
        state = empty ? newRequest.hold() ? RegulationState.HOLD : RegulationState.IDLE : RegulationState.START;
    }

    @Override
    public synchronized void adjustSpeed(float degreesPerSecond) {
        log.add("adjustSpeed " + degreesPerSecond);
        start(new MoveRequest(degreesPerSecond, request.accelerationDegreesPerSecondSquared(), request.limitDegrees(),
                request.hold()));
    }

    @Override
    public synchronized void adjustAcceleration(int degreesPerSecondSquared) {
        log.add("adjustAcceleration " + degreesPerSecondSquared);
        start(new MoveRequest(request.speedDegreesPerSecond(), degreesPerSecondSquared, request.limitDegrees(),
                request.hold()));
    }

    @Override
    public synchronized void setStallThreshold(int errorDegrees, int timeMillis) {
        log.add("setStallThreshold " + errorDegrees + " " + timeMillis);
        stallError = errorDegrees;
        stallTime = timeMillis;
    }

    @Override
    public synchronized MotorSnapshot snapshot() {
        return new MotorSnapshot(state, tachoDegrees(), (float) position, (float) velocity);
    }

    /**
     * Lets the brick's time pass until this motor stands; daemons only watch and wait for the others to let it pass.
     */
    @Override
    public void awaitStandstill() {
        if (Thread.currentThread().isDaemon()) {
            watchUntilStandstill();
            return;
        }
        Runnable action;
        synchronized (this) {
            action = whileWaiting;
            whileWaiting = () -> {};
        }
        action.run();
        for (int i = 0; snapshot().state().moving(); i++) {
            if (i == PATIENCE_MILLIS) {
                throw new AssertionError("the program would wait for ever: " + request);
            }
            brick.advance(1);
        }
    }

    private synchronized void watchUntilStandstill() {
        boolean interrupted = false;
        while (state.moving()) {
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
}
