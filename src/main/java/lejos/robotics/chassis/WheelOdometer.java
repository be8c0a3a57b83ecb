package lejos.robotics.chassis;

import java.util.function.Supplier;
import lejos.robotics.localization.PoseProvider;
import lejos.robotics.navigation.Pose;
import lejos.utility.Delay;
import lejos.utility.Matrix;

/**
 * Adds up what the wheels turn. A daemon thread looks at them, the more often the faster they turn, and each question
 * for the pose does so too.
 *
 * <p>May be used by any thread; this object's lock guards the pose.
 */
class WheelOdometer implements PoseProvider {
    private static final int SHORTEST_PAUSE_MILLIS = 4;
    private static final int LONGEST_PAUSE_MILLIS = 64;

    /** The greatest step of a wheel worth making, in degrees. */
    private static final double LARGE_STEP_DEGREES = 10;
    private static final double FULL_TURN = 360;
    private static final double HALF_TURN = 180;

    private final Supplier<Matrix> tachos;
    private final Matrix reverse;
    private Matrix last;
    private double x;
    private double y;
    private double heading;

    /** An odometer at the origin. */
    WheelOdometer(Supplier<Matrix> tachos, Matrix reverse) {
        this.tachos = tachos;
        this.reverse = reverse;
        this.last = tachos.get();
    }

    /** Starts the thread. */
    final void start() {
        Thread tracker = new Thread(this::track, "odometer");
        tracker.setDaemon(true);
        tracker.start();
    }

    /** Where the wheels say that the robot is now. */
    @Override
    public synchronized Pose getPose() {
        step();
        return new Pose((float) x, (float) y, (float) heading);
    }

    /** Tells where the robot is. */
    @Override
    public synchronized void setPose(Pose pose) {
        step();
        x = pose.getX();
        y = pose.getY();
        heading = pose.getHeading();
    }

    private void track() {
        int pause = LONGEST_PAUSE_MILLIS;
        while (true) {
            boolean large = step() > LARGE_STEP_DEGREES;
            pause = large ? Math.max(SHORTEST_PAUSE_MILLIS, pause / 2) : Math.min(LONGEST_PAUSE_MILLIS, pause * 2);
            Delay.msDelay(pause);
        }
    }

    /** Adds the motion since the last step, in the direction of its middle; returns the greatest step of a wheel. */
    private synchronized double step() {
        Matrix now = tachos.get();
        Matrix turned = now.minus(last);
        last = now;
        Matrix moved = reverse.times(turned);
        double middle = StrictMath.toRadians(heading + moved.get(2, 0) / 2);
        double sine = StrictMath.sin(middle);
        double cosine = StrictMath.cos(middle);
        x += moved.get(0, 0) * cosine - moved.get(1, 0) * sine;
        y += moved.get(0, 0) * sine + moved.get(1, 0) * cosine;
        heading = normalize(heading + moved.get(2, 0));
        return greatest(turned);
    }

    private static double greatest(Matrix column) {
        double greatest = 0;
        for (double value : column.getRowPackedCopy()) {
            greatest = Math.max(greatest, Math.abs(value));
        }
        return greatest;
    }

    private static double normalize(double degrees) {
        double angle = degrees % FULL_TURN;
        if (angle > HALF_TURN) {
            return angle - FULL_TURN;
        }
        return angle <= -HALF_TURN ? angle + FULL_TURN : angle;
    }
}
