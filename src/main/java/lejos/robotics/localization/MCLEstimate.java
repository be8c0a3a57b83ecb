package lejos.robotics.localization;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.robotics.navigation.Pose;

/** Where a cloud of guesses is: means, extents and variances. */
record MCLEstimate(float x, float y, float heading, float minX, float maxX, float minY, float maxY,
        float varX, float varY, float varHeading) {
    static final MCLEstimate NONE = new MCLEstimate(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

    private static final float FULL_TURN = 360;
    private static final float HALF_TURN = 180;

    static MCLEstimate of(MCLParticleSet particles) {
        Axis xs = new Axis();
        Axis ys = new Axis();
        Axis headings = new Axis();
        for (int i = 0; i < particles.numParticles(); i++) {
            Pose pose = particles.getParticle(i).getPose();
            xs.add(pose.getX());
            ys.add(pose.getY());
            headings.add(pose.getHeading());
        }
        return new MCLEstimate(xs.mean(), ys.mean(), normalize(headings.mean()), xs.min, xs.max, ys.min, ys.max,
                xs.variance(), ys.variance(), headings.variance());
    }

    Pose pose() {
        return new Pose(x, y, heading);
    }

    void write(DataOutputStream out) throws IOException {
        for (float value : new float[] {x, y, heading, minX, maxX, minY, maxY, varX, varY, varHeading}) {
            out.writeFloat(value);
        }
    }

    static MCLEstimate read(DataInputStream in) throws IOException {
        return new MCLEstimate(in.readFloat(), in.readFloat(), in.readFloat(), in.readFloat(), in.readFloat(),
                in.readFloat(), in.readFloat(), in.readFloat(), in.readFloat(), in.readFloat());
    }

    private static float normalize(float angle) {
        float wrapped = angle;
        while (wrapped > HALF_TURN) {
            wrapped -= FULL_TURN;
        }
        while (wrapped < -HALF_TURN) {
            wrapped += FULL_TURN;
        }
        return wrapped;
    }

    private static final class Axis {
        private int count;
        private double sum;
        private double squares;
        private float min = Float.POSITIVE_INFINITY;
        private float max = Float.NEGATIVE_INFINITY;

        void add(float value) {
            count++;
            sum += value;
            squares += (double) value * value;
            min = Math.min(min, value);
            max = Math.max(max, value);
        }

        float mean() {
            return (float) (sum / count);
        }

        float variance() {
            double mean = sum / count;
            return (float) Math.max(0, squares / count - mean * mean);
        }
    }
}
