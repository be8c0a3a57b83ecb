package lejos.robotics.localization;

import java.util.ArrayList;
import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;
import lejos.Bytes;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Point;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;
import lejos.robotics.objectdetection.RangeFeature;

/** Drives pose providers without their random parts. */
final class LocalizationDriver {
    private static final LineMap ROOM = new LineMap(new Line[] {new Line(0, 0, 200, 0), new Line(200, 0, 200, 100),
        new Line(200, 100, 0, 100), new Line(0, 100, 0, 0)}, new Rectangle(0, 0, 200, 100));

    private LocalizationDriver() {}

    static Map<String, Double> play(int seed) {
        Random random = new Random(seed);
        Sightings seen = new Sightings();
        odometry(seen, random);
        particles(seen, random);
        beacons(seen, random);
        return seen;
    }

    private static void odometry(Sightings seen, Random random) {
        FakePilot pilot = new FakePilot();
        OdometryPoseProvider odometry = new OdometryPoseProvider(pilot);
        note(seen, "origin", odometry.getPose());
        for (int i = 0; i < 8; i++) {
            Move.MoveType type = Move.MoveType.values()[random.nextInt(4)];
            float distance = type == Move.MoveType.ROTATE || type == Move.MoveType.STOP
                    ? 0 : random.nextFloat() * 100 - 50;
            float angle = type == Move.MoveType.TRAVEL || type == Move.MoveType.STOP
                    ? 0 : random.nextFloat() * 400 - 200;
            pilot.start();
            if (random.nextBoolean()) {
                pilot.progress(type, distance / 3, angle / 3);
                note(seen, "during " + i, odometry.getPose());
            }
            pilot.stop(type, distance, angle);
            note(seen, "after " + i, odometry.getPose());
            if (i == 4) {
                odometry.setPose(new Pose(10, 20, 200));
                note(seen, "set", odometry.getPose());
            }
        }
        float[] sample = new float[4];
        odometry.fetchSample(sample, 1);
        seen.note("sample", sample[1] + sample[2] + sample[3]).note("sample size", odometry.sampleSize());
    }

    private static void particles(Sightings seen, Random random) {
        MCLParticleSet set = new MCLParticleSet(ROOM, 6,
                new Pose(80 + random.nextInt(40), 50, random.nextInt(360)), 0, 0);
        RangeReadings readings = new RangeReadings(3);
        for (int i = 0; i < 3; i++) {
            readings.setRange(i, i * 90 - 90, 20 + random.nextInt(100));
        }
        seen.note("explained", set.calculateWeights(readings, ROOM)).note("max weight", set.getMaxWeight());
        set.setSigma(60);
        seen.note("explained now", set.calculateWeights(readings, ROOM)).note("max weight now", set.getMaxWeight());
        for (int i = 0; i < 6; i++) {
            set.getParticle(i).setWeight(i / 8f);
        }
        seen.note("heaviest", set.getMaxWeight());
        // the first number is the greatest weight, which the published class may forget
        Bytes.note(seen, "set", set, Float.BYTES);
        seen.note("closest", set.findClosest(random.nextInt(200), 30)).note("none", set.findClosest(1e6f, 0));
        set.setDistanceNoiseFactor(0);
        set.setAngleNoiseFactor(0);
        set.applyMove(new Move(random.nextInt(30), random.nextInt(300) - 150, false));
        note(seen, "particle", set.getParticle(2).getPose());
        seen.note("reading", set.getParticle(0).getReading(1, readings, ROOM));
        seen.note("predicted", set.getParticle(0).getReadings(readings, ROOM).getRange(2));
        feature(seen, readings, set.getParticle(1).getPose());
        MCLPoseProvider provider = new MCLPoseProvider(ROOM, 6, 5);
        provider.setParticles(set);
        provider.estimatePose();
        note(seen, "estimate", provider.getEstimatedPose());
        seen.note("extent", provider.getXRange() + provider.getYRange()).note("min x", provider.getMinX());
        seen.note("updated", provider.isUpdated() || provider.isLost() || provider.isBusy() || provider.update());
        seen.note("error", provider.getErrorRect().getCenterX());
        wire(seen, provider);
    }

    /** The last 8 bytes of a feature are the time. */
    private static void feature(Sightings seen, RangeReadings readings, Pose pose) {
        RangeFeature feature = new RangeFeature(readings, pose);
        Bytes.note(seen, "feature", feature, 24);
        RangeFeature copy = Bytes.copy(feature, new RangeFeature(new RangeReading(1, 2)));
        note(seen, "feature pose", copy.getPose());
        seen.note("feature range", copy.getRangeReading().getRange())
                .note("feature angle", copy.getRangeReading().getAngle());
        seen.note("feature readings", feature.getRangeReadings().getNumReadings());
    }

    /**
     * Means are rounded in another order, so that last bits differ: not the bytes but the numbers in them are compared.
     */
    private static void wire(Sightings seen, MCLPoseProvider provider) {
        Bytes.note(seen, "provider", provider, 10 * Float.BYTES);
        MCLPoseProvider copy = Bytes.copy(provider, new MCLPoseProvider(ROOM, 1, 0));
        note(seen, "copied estimate", copy.getEstimatedPose());
        seen.note("copied min x", copy.getMinX()).note("copied max x", copy.getMaxX())
                .note("copied min y", copy.getMinY());
        seen.note("copied max y", copy.getMaxY());
    }

    private static void beacons(Sightings seen, Random random) {
        Point[] places = new Point[3];
        for (int i = 0; i < 3; i++) {
            places[i] = new Point(i * 60 + random.nextInt(30), i == 1 ? 200 + random.nextInt(20) : random.nextInt(20));
        }
        Pose robot = new Pose(50 + random.nextInt(40), 60 + random.nextInt(40), random.nextInt(360) - 180);
        double[] bearings = new double[3];
        ArrayList<Double> list = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            bearings[i] = (robot.relativeBearing(places[i]) + 360) % 360;
            list.add(bearings[i]);
        }
        Pose found = new BeaconTriangle(places[0], places[1], places[2])
                .calcPose(bearings[0], bearings[1], bearings[2]);
        seen.note("found x", Math.round(found.getX())).note("found y", Math.round(found.getY()));
        seen.note("found heading cosine", Math.cos(Math.toRadians(Math.round(found.getHeading()))));
        seen.note("largest", BeaconPoseProvider.getLargestIndex(list));
    }

    private static void note(Sightings seen, String label, Pose pose) {
        seen.note(label + ".x", pose.getX()).note(label + ".y", pose.getY())
                .note(label + ".heading", pose.getHeading());
    }
}
