package lejos.robotics.navigation;

import java.util.ArrayList;
import java.util.List;

/**
 * A robot that does at once and exactly what it is told, and notes it. Of an arc, the sign of the distance is forward.
 */
final class FakeController implements ArcRotateMoveController {
    private final List<String> calls = new ArrayList<>();
    private final List<MoveListener> listeners = new ArrayList<>();
    private final double minRadius;
    private volatile Move last = new Move(0, 0, false);
    private volatile boolean endless;

    FakeController(double minRadius) {
        this.minRadius = minRadius;
    }

    /** From now on the robot drives on until stopped. */
    void setEndless() {
        endless = true;
    }

    synchronized List<String> calls() {
        return new ArrayList<>(calls);
    }

    private synchronized void note(String call, double... numbers) {
        StringBuilder line = new StringBuilder(call);
        for (double number : numbers) {
            line.append(' ').append(Double.isInfinite(number)
                    ? "infinite" : String.valueOf(Math.round(number * 10) / 10.0));
        }
        calls.add(line.toString());
    }

    private void move(Move move) {
        last = move;
        for (MoveListener listener : listeners) {
            listener.moveStarted(new Move(0, 0, true), this);
            listener.moveStopped(move, this);
        }
    }

    @Override
    public void rotate(double angle, boolean immediateReturn) {
        note("rotate", angle);
        move(new Move(Move.MoveType.ROTATE, 0, (float) angle, false));
    }

    @Override
    public void travel(double distance, boolean immediateReturn) {
        note("travel", distance);
        move(new Move(Move.MoveType.TRAVEL, (float) distance, 0, false));
    }

    @Override
    public void travelArc(double radius, double distance, boolean immediateReturn) {
        note("arc", radius, distance);
        if (Double.isInfinite(radius)) {
            move(new Move(Move.MoveType.TRAVEL, (float) distance, 0, false));
        } else {
            move(new Move(Move.MoveType.ARC, (float) distance, (float) Math.toDegrees(distance / radius), false));
        }
    }

    @Override
    public void stop() {
        note("stop");
        endless = false;
    }

    @Override
    public boolean isMoving() {
        return endless;
    }

    @Override
    public Move getMovement() {
        return last;
    }

    @Override
    public void addMoveListener(MoveListener listener) {
        listeners.add(listener);
    }

    @Override
    public double getMinRadius() {
        return minRadius;
    }

    @Override
    public void rotate(double angle) {
        rotate(angle, false);
    }

    @Override
    public void travel(double distance) {
        travel(distance, false);
    }

    @Override
    public void travelArc(double radius, double distance) {
        travelArc(radius, distance, false);
    }

    @Override
    public void setMinRadius(double radius) {}

    @Override
    public void arcForward(double radius) {}

    @Override
    public void arcBackward(double radius) {}

    @Override
    public void arc(double radius, double angle) {}

    @Override
    public void arc(double radius, double angle, boolean immediateReturn) {}

    @Override
    public void forward() {}

    @Override
    public void backward() {}

    @Override
    public void rotateRight() {}

    @Override
    public void rotateLeft() {}

    @Override
    public void setLinearSpeed(double speed) {}

    @Override
    public double getLinearSpeed() {
        return 0;
    }

    @Override
    public double getMaxLinearSpeed() {
        return 0;
    }

    @Override
    public void setLinearAcceleration(double acceleration) {}

    @Override
    public double getLinearAcceleration() {
        return 0;
    }

    @Override
    public void setAngularSpeed(double speed) {}

    @Override
    public double getAngularSpeed() {
        return 0;
    }

    @Override
    public double getMaxAngularSpeed() {
        return 0;
    }

    @Override
    public void setAngularAcceleration(double acceleration) {}

    @Override
    public double getAngularAcceleration() {
        return 0;
    }
}
