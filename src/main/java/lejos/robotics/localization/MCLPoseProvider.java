package lejos.robotics.localization;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.robotics.RangeReadings;
import lejos.robotics.RangeScanner;
import lejos.robotics.Transmittable;
import lejos.robotics.geometry.Rectangle2D;
import lejos.robotics.geometry.RectangleInt32;
import lejos.robotics.mapping.RangeMap;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.Pose;

/**
 * Monte Carlo localisation: keeps a cloud of guesses of the pose, moves it as the robot moves and thins it out by range
 * readings.
 *
 * <p>After a move, {@link #getPose} scans with the range scanner, which turns a head or the robot.
 */
public class MCLPoseProvider implements PoseProvider, MoveListener, Transmittable {
    private static final float ACCEPTED_WEIGHT = 0.3f;

    private final RangeScanner scanner;
    private final int numParticles;
    private final int border;
    private RangeMap map;
    private MCLParticleSet particles;
    private RangeReadings readings;
    private boolean updated;
    private boolean incomplete;
    private boolean debug;
    private MCLEstimate estimate = MCLEstimate.NONE;

    /**
     * A provider with guesses all over the map, if there is one.
     *
     * @param mp the pilot to listen to, or null
     * @param scanner takes range readings
     * @param map the walls, or null
     * @param numParticles number of guesses
     * @param border least distance of guesses from the edges of the map's rectangle
     */
    public MCLPoseProvider(MoveProvider mp, RangeScanner scanner, RangeMap map, int numParticles, int border) {
        this.scanner = scanner;
        this.map = map;
        this.numParticles = numParticles;
        this.border = border;
        if (numParticles > 0 && map != null) {
            generateParticles();
        }
        if (mp != null) {
            mp.addMoveListener(this);
        }
    }

    /** A provider without scanner, pilot and, as yet, guesses. */
    public MCLPoseProvider(RangeMap map, int numParticles, int border) {
        this.scanner = null;
        this.map = map;
        this.numParticles = numParticles;
        this.border = border;
    }

    /** Sets the map. */
    public void setMap(RangeMap map) {
        this.map = map;
    }

    /** Makes new guesses around a pose, with standard deviations of distance and heading. */
    public void setInitialPose(Pose aPose, float radiusNoise, float headingNoise) {
        particles = new MCLParticleSet(map, numParticles, aPose, radiusNoise, headingNoise);
    }

    /** Makes new guesses that explain readings with a standard deviation. */
    public void setInitialPose(RangeReadings readings, float sigma) {
        float divisor = 2 * sigma * sigma;
        particles = new MCLParticleSet(map, numParticles, border, readings, divisor, ACCEPTED_WEIGHT);
        updated = true;
    }

    /** Turns the printing of what goes on on or off. */
    public void setDebug(boolean on) {
        debug = on;
    }

    /** Makes new guesses close around a pose. */
    @Override
    public void setPose(Pose aPose) {
        setInitialPose(aPose, 1, 1);
        updated = true;
    }

    /** The guesses; null if there are none yet. */
    public MCLParticleSet getParticles() {
        return particles;
    }

    /** The last readings; null before the first. */
    public RangeReadings getReadings() {
        return readings;
    }

    /** Sets the guesses. */
    public void setParticles(MCLParticleSet particles) {
        this.particles = particles;
    }

    /** Makes new guesses all over the map. */
    public void generateParticles() {
        particles = new MCLParticleSet(map, numParticles, border);
    }

    @Override
    public void moveStarted(Move event, MoveProvider mp) {
        updated = false;
    }

    /** Moves all guesses, on the pilot's thread. */
    @Override
    public void moveStopped(Move event, MoveProvider mp) {
        particles.applyMove(event);
    }

    /** Scans and thins out the guesses; false if that did not work, as without a scanner or with an invalid reading. */
    public boolean update() {
        if (scanner == null) {
            return false;
        }
        readings = scanner.getRangeValues();
        incomplete = readings.incomplete();
        return !incomplete && update(readings);
    }

    /** Thins out the guesses by readings; false if that did not work. */
    public boolean update(RangeReadings readings) {
        boolean explained = particles.calculateWeights(readings, map);
        if (debug) {
            System.out.println("Greatest weight " + particles.getMaxWeight());
        }
        if (!explained) {
            updated = false;
            return false;
        }
        updated = particles.resample();
        return updated;
    }

    /** Whether the guesses take the last move and the readings after it into account. */
    public boolean isUpdated() {
        return updated;
    }

    /** Always false; leJOS does not find out. */
    public boolean isLost() {
        return false;
    }

    /** Whether a reading of the last scan was invalid. */
    public boolean incompleteRanges() {
        return incomplete;
    }

    /** Extent of the guesses along x at the last estimate. */
    public float getXRange() {
        return getMaxX() - getMinX();
    }

    /** Extent of the guesses along y at the last estimate. */
    public float getYRange() {
        return getMaxY() - getMinY();
    }

    /** The mean of the guesses; scans first if the robot has moved since the last scan. */
    @Override
    public Pose getPose() {
        if (!updated) {
            update();
        }
        estimatePose();
        return getEstimatedPose();
    }

    /** The last estimate. */
    public Pose getEstimatedPose() {
        return estimate.pose();
    }

    /** Makes an estimate: the mean of the guesses, headings taken as plain numbers. */
    public void estimatePose() {
        estimate = MCLEstimate.of(particles);
    }

    /** The last readings; null before the first. */
    public RangeReadings getRangeReadings() {
        return readings;
    }

    /** A rectangle around the guesses at the last estimate; coordinates lose their fractions. */
    public Rectangle2D getErrorRect() {
        return new RectangleInt32((int) getMinX(), (int) getMinY(), (int) getXRange(), (int) getYRange());
    }

    /** Highest x coordinate of the guesses at the last estimate. */
    public float getMaxX() {
        return estimate.maxX();
    }

    /** Lowest x coordinate of the guesses at the last estimate. */
    public float getMinX() {
        return estimate.minX();
    }

    /** Highest y coordinate of the guesses at the last estimate. */
    public float getMaxY() {
        return estimate.maxY();
    }

    /** Lowest y coordinate of the guesses at the last estimate. */
    public float getMinY() {
        return estimate.minY();
    }

    /** Standard deviation of x at the last estimate. */
    public float getSigmaX() {
        return (float) Math.sqrt(estimate.varX());
    }

    /** Standard deviation of y at the last estimate. */
    public float getSigmaY() {
        return (float) Math.sqrt(estimate.varY());
    }

    /** Standard deviation of the heading at the last estimate, in degrees. */
    public float getSigmaHeading() {
        return (float) Math.sqrt(estimate.varHeading());
    }

    /** The scanner. */
    public RangeScanner getScanner() {
        return scanner;
    }

    /** Writes the last estimate: x, y, heading, least and greatest x and y, and the variances. */
    @Override
    public void dumpObject(DataOutputStream dos) throws IOException {
        estimate.write(dos);
        dos.flush();
    }

    @Override
    public void loadObject(DataInputStream dis) throws IOException {
        estimate = MCLEstimate.read(dis);
    }

    /** Always false: nothing is done in the background. */
    public boolean isBusy() {
        return false;
    }
}
