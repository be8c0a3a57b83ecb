package lejos.hardware.motor;

/**
 * Planned motion of a motor with constant acceleration in each of three phases: change of speed, cruise, deceleration.
 *
 * <p>Degrees, degrees per second; phases end at whole milliseconds since the plan began. Immutable.
 */
final class MotionProfile {
    private static final int FOR_EVER = Integer.MAX_VALUE;
    private static final double MILLIS = 1000.0;

    private final double start;
    private final double startVelocity;
    private final double acceleration;
    private final int rampMillis;
    private final double cruiseStart;
    private final double velocity;
    private final int cruiseMillis;
    private final double brakeStart;
    private final double deceleration;
    private final int endMillis;
    private final double end;

    private MotionProfile(double start, double startVelocity, double acceleration, double velocity, double rampSeconds,
            double cruiseSeconds, double deceleration, double brakeSeconds, double end) {
        this.start = start;
        this.startVelocity = startVelocity;
        this.acceleration = acceleration;
        this.velocity = velocity;
        this.deceleration = deceleration;
        this.end = end;
        rampMillis = (int) (rampSeconds * MILLIS);
        cruiseStart = start + (startVelocity + velocity) / 2 * rampSeconds;
        cruiseMillis = (int) Math.min((rampSeconds + cruiseSeconds) * MILLIS, FOR_EVER);
        brakeStart = cruiseStart + velocity * (Double.isInfinite(cruiseSeconds) ? 0 : cruiseSeconds);
        endMillis = (int) Math.min((rampSeconds + cruiseSeconds + brakeSeconds) * MILLIS, FOR_EVER);
    }

    /** Slows down to a stop. */
    static MotionProfile stop(double position, double velocity, double acceleration) {
        double seconds = Math.abs(velocity) / acceleration;
        double end = position + velocity * seconds / 2;
        return new MotionProfile(position, velocity, 0, velocity, 0, 0, Math.copySign(acceleration, velocity), seconds,
                end);
    }

    /** Changes to a velocity and keeps it. */
    static MotionProfile endless(double position, double velocity, double target, double acceleration) {
        double ramp = target < velocity ? -acceleration : acceleration;
        double seconds = (target - velocity) / ramp;
        return new MotionProfile(position, velocity, ramp, target, seconds, Double.POSITIVE_INFINITY, 0, 0, position);
    }

    /**
     * Goes to a position and stops there; a target nearer than the braking distance is passed and approached from
     * behind.
     */
    static MotionProfile to(double limit, double position, double velocity, double speed, double acceleration) {
        double length = limit - position;
        double brakingDistance = velocity * Math.abs(velocity) / (2 * acceleration);
        boolean backward = velocity == 0 ? length < 0 : length < brakingDistance;
        double cruise = backward ? -speed : speed;
        double brake = backward ? -acceleration : acceleration;
        double peakSquared = brake * length + velocity * velocity / 2;
        boolean triangle = peakSquared <= speed * speed;
        if (triangle) {
            cruise = Math.copySign(StrictMath.sqrt(Math.max(0, peakSquared)), cruise);
        }
        double ramp = cruise < velocity ? -acceleration : acceleration;
        double rampLength = (cruise * cruise - velocity * velocity) / (2 * ramp);
        double brakeLength = cruise * cruise / (2 * brake);
        double cruiseSeconds = triangle ? 0 : (length - rampLength - brakeLength) / cruise;
        return new MotionProfile(position, velocity, ramp, cruise, (cruise - velocity) / ramp, cruiseSeconds,
                brake, cruise / brake, limit);
    }

    /** Whether the plan contains any motion. */
    boolean moves() {
        return velocity != 0 || startVelocity != 0;
    }

    /** Whether the final deceleration has begun. */
    boolean braking(double millis) {
        return millis >= cruiseMillis;
    }

    /** Whether the plan is over. */
    boolean over(double millis) {
        return endMillis != FOR_EVER && millis >= endMillis;
    }

    /** When the plan is over, milliseconds; the largest int for never. */
    int endMillis() {
        return endMillis;
    }

    /** Planned position. */
    double position(double millis) {
        if (over(millis)) {
            return end;
        }
        if (millis >= cruiseMillis) {
            return travelled(brakeStart, velocity, -deceleration, millis - cruiseMillis);
        }
        if (millis >= rampMillis) {
            return travelled(cruiseStart, velocity, 0, millis - rampMillis);
        }
        return travelled(start, startVelocity, acceleration, millis);
    }

    /** Planned velocity. */
    double velocity(double millis) {
        if (over(millis)) {
            return 0;
        }
        if (millis >= cruiseMillis) {
            return velocity - deceleration * (millis - cruiseMillis) / MILLIS;
        }
        return millis >= rampMillis ? velocity : startVelocity + acceleration * millis / MILLIS;
    }

    private static double travelled(double from, double velocity, double acceleration, double millis) {
        double seconds = millis / MILLIS;
        return from + velocity * seconds + acceleration * seconds * seconds / 2;
    }
}
