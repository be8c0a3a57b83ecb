package lejos.robotics.localization;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Random;
import java.util.function.Supplier;
import lejos.robotics.RangeReadings;
import lejos.robotics.Transmittable;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.mapping.RangeMap;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;

/** A cloud of guesses of the robot's pose, which thins out where guesses explain badly what the robot measures. */
public class MCLParticleSet implements Transmittable {
    /** How often {@link #resample} draws before it gives up; shared by all sets. */
    public static int maxIterations = 1000;

    /** Chance; tests of this package choose its seed. */
    static final Random RANDOM = new Random();
    private static final float FULL_TURN = 360;
    private static final float LEAST_MAX_WEIGHT = 0.01f;
    private static final float FAR_AWAY = 10_000;
    /** Random poses tried for one particle before the map counts as having no inside. */
    private static final int MAX_TRIES = 1_000_000;

    private static boolean debug;

    private final RangeMap map;
    private MCLParticle[] particles;
    private int border;
    private float maxWeight;
    private float twoSigmaSquared = 400;
    private float distanceNoiseFactor = 0.2f;
    private float angleNoiseFactor = 4;
    private int tries;

    /**
     * Guesses all over the map.
     *
     * @param border least distance from the edges of the map's rectangle
     * @throws IllegalStateException if no place is inside
     */
    public MCLParticleSet(RangeMap map, int numParticles, int border) {
        this.map = map;
        this.border = border;
        fill(numParticles, this::randomParticle);
    }

    /**
     * Guesses all over the map that explain readings; prints how many were tried.
     *
     * @param divisor twice the variance of a reading
     * @param minWeight least weight of a guess to be taken
     * @throws IllegalStateException if hardly any place explains them
     */
    public MCLParticleSet(RangeMap map, int numParticles, int border, RangeReadings readings, float divisor,
            float minWeight) {
        this.map = map;
        this.border = border;
        fill(numParticles, () -> explainingParticle(readings, divisor, minWeight));
        System.out.println("Tried " + tries + " particles");
    }

    /**
     * Guesses around a pose.
     *
     * @param radiusNoise standard deviation of the distance from it
     * @param headingNoise standard deviation of the heading in degrees
     */
    public MCLParticleSet(RangeMap map, int numParticles, Pose initialPose, float radiusNoise, float headingNoise) {
        this.map = map;
        fill(numParticles, () -> particleNear(initialPose, radiusNoise, headingNoise));
    }

    /** Number of guesses. */
    public int numParticles() {
        return particles.length;
    }

    /** Turns the printing of what is measured and predicted on or off, for all sets. */
    public static void setDebug(boolean yes) {
        debug = yes;
        MCLParticle.setDebug(yes);
    }

    /** One of the guesses. */
    public MCLParticle getParticle(int i) {
        return particles[i];
    }

    /**
     * Draws a new set, in which guesses are the more likely the greater their weight.
     *
     * @return false if too few guesses were good enough, so that some are there many times; true if none was and the
     *     new set is spread all over the map
     */
    public boolean resample() {
        MCLParticle[] old = particles;
        particles = new MCLParticle[old.length];
        int count = 0;
        for (int i = 0; i < maxIterations && count < particles.length; i++) {
            float chance = RANDOM.nextFloat();
            for (int j = 0; j < old.length && count < particles.length; j++) {
                if (old[j].getWeight() >= chance) {
                    particles[count++] = copy(old[j]);
                }
            }
        }
        if (count == 0) {
            fill(old.length, this::randomParticle);
            return true;
        }
        boolean complete = count == particles.length;
        for (int i = count; i < particles.length; i++) {
            particles[i] = copy(particles[i % count]);
        }
        return complete;
    }

    /**
     * Weighs all guesses.
     *
     * @return false if a reading is invalid or if no guess explains them
     */
    public boolean calculateWeights(RangeReadings rr, RangeMap map) {
        if (rr.incomplete()) {
            return false;
        }
        if (debug) {
            rr.printReadings();
        }
        for (MCLParticle particle : particles) {
            particle.calculateWeight(rr, map, twoSigmaSquared);
        }
        return getMaxWeight() >= LEAST_MAX_WEIGHT;
    }

    /** Moves all guesses as the robot moved, give or take; without a move prints a line. */
    public void applyMove(Move move) {
        if (move == null) {
            System.out.println("No move to apply");
            return;
        }
        for (MCLParticle particle : particles) {
            particle.applyMove(move, distanceNoiseFactor, angleNoiseFactor);
        }
        maxWeight = 0;
    }

    /** The greatest weight. */
    public float getMaxWeight() {
        maxWeight = 0;
        for (MCLParticle particle : particles) {
            maxWeight = Math.max(maxWeight, particle.getWeight());
        }
        return maxWeight;
    }

    /** Least distance of new guesses from the edges of the map's rectangle. */
    public float getBorder() {
        return border;
    }

    /** Sets the least distance of new guesses from the edges of the map's rectangle. */
    public void setBorder(int border) {
        this.border = border;
    }

    /** Sets the standard deviation of a reading. */
    public void setSigma(float sigma) {
        twoSigmaSquared = 2 * sigma * sigma;
    }

    /** Sets the standard deviation of distances driven, as a share of them. */
    public void setDistanceNoiseFactor(float factor) {
        distanceNoiseFactor = factor;
    }

    /** Sets the standard deviation of turns in degrees. */
    public void setAngleNoiseFactor(float factor) {
        angleNoiseFactor = factor;
    }

    /** Sets {@link #maxIterations}. */
    public void setMaxIterations(int max) {
        maxIterations = max;
    }

    /** Index of the guess nearest to a place; −1 if all are farther than 10 000. */
    public int findClosest(float x, float y) {
        Pose place = new Pose(x, y, 0);
        float nearest = FAR_AWAY;
        int index = -1;
        for (int i = 0; i < particles.length; i++) {
            float distance = place.distanceTo(particles[i].getPose().getLocation());
            if (distance < nearest) {
                nearest = distance;
                index = i;
            }
        }
        return index;
    }

    /** Writes the greatest weight, the number of guesses, and of each x, y, heading and weight. */
    @Override
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeFloat(getMaxWeight());
        dos.writeInt(particles.length);
        for (MCLParticle particle : particles) {
            particle.getPose().dumpObject(dos);
            dos.writeFloat(particle.getWeight());
        }
        dos.flush();
    }

    /** Always 0; leJOS keeps no count. */
    public int getIterations() {
        return 0;
    }

    @Override
    public void loadObject(DataInputStream dis) throws IOException {
        maxWeight = dis.readFloat();
        particles = new MCLParticle[dis.readInt()];
        for (int i = 0; i < particles.length; i++) {
            Pose pose = new Pose();
            pose.loadObject(dis);
            particles[i] = new MCLParticle(pose);
            particles[i].setWeight(dis.readFloat());
        }
    }

    /** Writes of the guess nearest to a place its index, what it predicts and its weight. */
    public void dumpClosest(RangeReadings rr, DataOutputStream dos, float x, float y) throws IOException {
        int closest = findClosest(x, y);
        dos.writeInt(closest);
        particles[closest].getReadings(rr, map).dumpObject(dos);
        dos.writeFloat(particles[closest].getWeight());
        dos.flush();
    }

    private void fill(int count, Supplier<MCLParticle> source) {
        particles = new MCLParticle[count];
        for (int i = 0; i < count; i++) {
            particles[i] = source.get();
        }
    }

    private MCLParticle randomParticle() {
        Rectangle area = map.getBoundingRect();
        for (int i = 0; i < MAX_TRIES; i++) {
            float x = area.x + border + RANDOM.nextFloat() * (area.width - 2 * border);
            float y = area.y + border + RANDOM.nextFloat() * (area.height - 2 * border);
            Pose pose = new Pose(x, y, RANDOM.nextFloat() * FULL_TURN);
            if (map.inside(pose.getLocation())) {
                return new MCLParticle(pose);
            }
        }
        throw new IllegalStateException("no place inside the map found in " + MAX_TRIES + " tries");
    }

    private MCLParticle explainingParticle(RangeReadings readings, float divisor, float minWeight) {
        for (int i = 0; i < MAX_TRIES; i++) {
            tries++;
            MCLParticle particle = randomParticle();
            particle.calculateWeight(readings, map, divisor);
            if (particle.getWeight() > minWeight) {
                return particle;
            }
        }
        throw new IllegalStateException("no place that explains the readings found in " + MAX_TRIES + " tries");
    }

    private static MCLParticle particleNear(Pose center, float radiusNoise, float headingNoise) {
        float distance = radiusNoise * (float) RANDOM.nextGaussian();
        float heading = center.getHeading() + headingNoise * (float) RANDOM.nextGaussian();
        Pose pose = new Pose(0, 0, heading);
        pose.setLocation(center.pointAt(distance, RANDOM.nextFloat() * FULL_TURN));
        return new MCLParticle(pose);
    }

    private static MCLParticle copy(MCLParticle particle) {
        Pose pose = particle.getPose();
        MCLParticle copy = new MCLParticle(new Pose(pose.getX(), pose.getY(), pose.getHeading()));
        copy.setWeight(particle.getWeight());
        return copy;
    }
}
