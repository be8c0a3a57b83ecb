package lejos.utility;

/**
 * Estimates the state of a linear system with noise.
 *
 * <p>The system is {@code x' = A x + B u} with noise covariance R, measured as {@code z = C x} with noise covariance Q.
 * (Textbooks often name the two noises the other way round.)
 */
public class KalmanFilter {
    private final Matrix a;
    private final Matrix b;
    private final Matrix c;
    private final Matrix q;
    private final Matrix r;
    private final Matrix identity;
    private Matrix mean;
    private Matrix covariance;
    private Matrix predictedMean;
    private Matrix predictedCovariance;
    private Matrix gain;

    /**
     * A filter; {@link #setState} must be called before the first update.
     *
     * @param a state transition
     * @param b effect of the control
     * @param c what is measured of the state
     * @param q covariance of the measurement noise
     * @param r covariance of the process noise
     */
    public KalmanFilter(Matrix a, Matrix b, Matrix c, Matrix q, Matrix r) {
        this.a = a;
        this.b = b;
        this.c = c;
        this.q = q;
        this.r = r;
        this.identity = Matrix.identity(a.getRowDimension(), a.getColumnDimension());
    }

    /** Sets the present estimate. */
    public void setState(Matrix mean, Matrix covariance) {
        this.mean = mean;
        this.covariance = covariance;
    }

    /** Predicts the next state under a control, then corrects it by a measurement. */
    public void update(Matrix control, Matrix measurement) {
        predictedMean = a.times(mean).plus(b.times(control));
        predictedCovariance = a.times(covariance).times(a.transpose()).plus(r);
        Matrix cTransposed = c.transpose();
        Matrix innovationCovariance = c.times(predictedCovariance).times(cTransposed).plus(q);
        gain = predictedCovariance.times(cTransposed).times(innovationCovariance.inverse());
        mean = predictedMean.plus(gain.times(measurement.minus(c.times(predictedMean))));
        covariance = identity.minus(gain.times(c)).times(predictedCovariance);
    }

    /** Estimated state. */
    public Matrix getMean() {
        return mean;
    }

    /** Covariance of the estimate. */
    public Matrix getCovariance() {
        return covariance;
    }

    /** State predicted by the last update; null before it. */
    public Matrix getPredictedMean() {
        return predictedMean;
    }

    /** Covariance predicted by the last update; null before it. */
    public Matrix getPredictedCovariance() {
        return predictedCovariance;
    }

    /** Gain of the last update; null before it. */
    public Matrix getGain() {
        return gain;
    }
}
