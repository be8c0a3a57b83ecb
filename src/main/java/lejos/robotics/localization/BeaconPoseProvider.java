package lejos.robotics.localization;

import java.util.ArrayList;
import java.util.Collections;
import lejos.hardware.Sound;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.Pose;

/**
 * Dead reckoning that is put right from time to time by the bearings of three beacons.
 *
 * <p>At the first look the locator must name the beacons in the triangle's order; later the order is found out.
 */
public class BeaconPoseProvider implements PoseProvider, MoveListener {
    private static final int DEFAULT_INTERVAL = 5;
    private static final int BEACONS = 3;
    private static final double FULL_TURN = 360;
    private static final double HALF_TURN = 180;

    private final BeaconLocator locator;
    private final BeaconTriangle triangle;
    private final OdometryPoseProvider odometry;
    private final int scanInterval;
    private int movesSinceScan;
    private boolean located;

    /** A provider that looks for beacons after every five moves. */
    public BeaconPoseProvider(BeaconLocator bl, BeaconTriangle bt, MoveProvider mp) {
        this(bl, bt, mp, DEFAULT_INTERVAL);
    }

    /** A provider that looks for beacons at first and then after so many moves. */
    public BeaconPoseProvider(BeaconLocator bl, BeaconTriangle bt, MoveProvider mp, int scanInterval) {
        this.locator = bl;
        this.triangle = bt;
        this.odometry = new OdometryPoseProvider(mp);
        this.scanInterval = scanInterval;
        this.movesSinceScan = scanInterval;
        mp.addMoveListener(this);
    }

    /** The pose; looks for beacons first if it is time to, and buzzes if it does not see three. */
    @Override
    public Pose getPose() {
        if (movesSinceScan >= scanInterval) {
            movesSinceScan = 0;
            scan();
        }
        return odometry.getPose();
    }

    /** Index of the largest number; −1 if there is none. */
    public static int getLargestIndex(ArrayList<Double> numbers) {
        return numbers.isEmpty() ? -1 : numbers.indexOf(Collections.max(numbers));
    }

    /** Does nothing: the beacons say where the robot is. */
    @Override
    public void setPose(Pose aPose) {
        // Kept as leJOS has it; see above.
    }

    @Override
    public void moveStarted(Move event, MoveProvider mp) {
        // Only ends of moves count.
    }

    @Override
    public void moveStopped(Move event, MoveProvider mp) {
        movesSinceScan++;
    }

    private void scan() {
        ArrayList<Double> bearings = new ArrayList<>(locator.locate());
        if (bearings.size() != BEACONS) {
            Sound.buzz();
            return;
        }
        if (located) {
            Collections.rotate(bearings, bestRotation(bearings));
        }
        located = true;
        odometry.setPose(triangle.calcPose(bearings.get(0), bearings.get(1), bearings.get(2)));
    }

    /** By how many places the bearings must be moved on to be most like those expected. */
    private int bestRotation(ArrayList<Double> bearings) {
        double[] expected = triangle.bearingsFrom(odometry.getPose());
        int best = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int rotation = 0; rotation < BEACONS; rotation++) {
            double error = 0;
            for (int i = 0; i < BEACONS; i++) {
                error += difference(bearings.get(i), expected[(i + rotation) % BEACONS]);
            }
            if (error < least) {
                least = error;
                best = rotation;
            }
        }
        return best;
    }

    private static double difference(double a, double b) {
        double turn = Math.abs(a - b) % FULL_TURN;
        return turn > HALF_TURN ? FULL_TURN - turn : turn;
    }
}
