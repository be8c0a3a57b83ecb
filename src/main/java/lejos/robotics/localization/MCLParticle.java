package lejos.robotics.localization;

import java.util.Random;
import lejos.robotics.RangeReadings;
import lejos.robotics.mapping.RangeMap;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;

/** One guess of the robot's pose, and how well it explains what the robot measures. */
public class MCLParticle {
    /** Chance; tests of this package choose its seed. */
    static final Random RANDOM = new Random();
    private static final int FULL_TURN = 360;

    private static boolean debug;

    private final Pose pose;
    private float weight = 1;

    /** A guess of weight 1; the pose is not copied. */
    public MCLParticle(Pose pose) {
        this.pose = pose;
    }

    /** Turns the printing of weights on or off. */
    public static void setDebug(boolean yes) {
        debug = yes;
    }

    /** Sets the weight. */
    public void setWeight(float weight) {
        this.weight = weight;
    }

    /** The weight, 0 (impossible) to 1. */
    public float getWeight() {
        return weight;
    }

    /** The pose guessed: the particle's own. */
    public Pose getPose() {
        return pose;
    }

    /**
     * Weighs the guess: the product of a normal distribution over the errors of all readings.
     *
     * @param rr what the robot measured
     * @param map the walls
     * @param divisor twice the variance of a reading
     */
    public void calculateWeight(RangeReadings rr, RangeMap map, float divisor) {
        weight = map.inside(pose.getLocation()) ? 1 : 0;
        for (int i = 0; i < rr.getNumReadings() && weight > 0; i++) {
            float predicted = getReading(i, rr, map);
            float error = rr.getRange(i) - predicted;
            weight *= predicted < 0 ? 0 : (float) StrictMath.exp(-error * error / divisor);
        }
        if (debug) {
            System.out.println("Weight " + weight + " at " + pose);
        }
    }

    /** What the robot would measure here at the angle of a reading; −1 if nothing. */
    public float getReading(int i, RangeReadings rr, RangeMap map) {
        return map.range(new Pose(pose.getX(), pose.getY(), pose.getHeading() + rr.getAngle(i)));
    }

    /** What the robot would measure here at the angles of readings. */
    public RangeReadings getReadings(RangeReadings rr, RangeMap map) {
        RangeReadings predicted = new RangeReadings(rr.getNumReadings());
        for (int i = 0; i < rr.getNumReadings(); i++) {
            predicted.setRange(i, rr.getAngle(i), getReading(i, rr, map));
        }
        return predicted;
    }

    /**
     * Moves the guess as the robot moved, straight along the old heading, give or take. The heading becomes a whole
     * number.
     *
     * @param move what the robot did
     * @param distanceNoiseFactor standard deviation of the distance along each axis, as a share of it
     * @param angleNoiseFactor standard deviation of the heading in degrees
     */
    public void applyMove(Move move, float distanceNoiseFactor, float angleNoiseFactor) {
        double radians = StrictMath.toRadians(pose.getHeading());
        double dx = move.getDistanceTraveled() * StrictMath.cos(radians);
        double dy = move.getDistanceTraveled() * StrictMath.sin(radians);
        double x = pose.getX() + dx + distanceNoiseFactor * dx * RANDOM.nextGaussian();
        double y = pose.getY() + dy + distanceNoiseFactor * dy * RANDOM.nextGaussian();
        double turned = pose.getHeading() + move.getAngleTurned() + angleNoiseFactor * RANDOM.nextGaussian();
        pose.setLocation((float) x, (float) y);
        pose.setHeading((int) (turned + 0.5) % FULL_TURN);
    }
}
