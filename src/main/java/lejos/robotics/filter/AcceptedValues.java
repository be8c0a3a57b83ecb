package lejos.robotics.filter;

/** The last values that were not far from the others. */
final class AcceptedValues {
    private static final int ALWAYS_ACCEPTED = 15;
    private static final int DEVIATIONS = 2;

    private final float[] ring;
    private int next;
    private int count;

    AcceptedValues(int capacity) {
        ring = new float[capacity];
    }

    /** Takes the value up unless it is far from the others, or not a number. */
    void offer(float value) {
        boolean far = count >= ALWAYS_ACCEPTED && Math.abs(value - mean()) > DEVIATIONS * standardDeviation();
        if (Float.isNaN(value) || far) {
            return;
        }
        ring[next] = value;
        next = (next + 1) % ring.length;
        count = Math.min(count + 1, ring.length);
    }

    /** Mean; not a number if there are no values. */
    double mean() {
        double sum = 0;
        for (int i = 0; i < count; i++) {
            sum += ring[i];
        }
        return sum / count;
    }

    /** Standard deviation of a sample; not a number if there are fewer than two values. */
    double standardDeviation() {
        double mean = mean();
        double squares = 0;
        for (int i = 0; i < count; i++) {
            squares += (ring[i] - mean) * (ring[i] - mean);
        }
        return Math.sqrt(squares / (count - 1));
    }
}
