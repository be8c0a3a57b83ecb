package lejos.robotics.localization;

import java.util.ArrayList;
import java.util.List;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;

/** A pilot that does what a test says. */
final class FakePilot implements MoveProvider {
    private final List<MoveListener> listeners = new ArrayList<>();
    private Move progress = new Move(0, 0, false);

    @Override
    public Move getMovement() {
        return progress;
    }

    @Override
    public void addMoveListener(MoveListener listener) {
        listeners.add(listener);
    }

    void start() {
        progress = new Move(0, 0, true);
        listeners.forEach(listener -> listener.moveStarted(progress, this));
    }

    void progress(Move.MoveType type, float distance, float angle) {
        progress = new Move(type, distance, angle, true);
    }

    void stop(Move.MoveType type, float distance, float angle) {
        progress = new Move(type, distance, angle, false);
        listeners.forEach(listener -> listener.moveStopped(progress, this));
    }
}
