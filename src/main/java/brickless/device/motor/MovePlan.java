package brickless.device.motor;

import brickless.hardware.MotorRegulation;
import brickless.hardware.MoveRequest;

/**
 * A move as a function of time: speed up, run, slow down, all at one constant acceleration, from any starting velocity.
 *
 * <p>Positions are degrees, velocities degrees per second, in {@code float}, and times whole milliseconds (truncated),
 * as in the original; the golden vectors of the published library pass.
 */
final class MovePlan {
    private static final float MILLIS = 1000;
    /**
     * An acceleration of 0 counts as this, degrees per second squared: a holonomic chassis gives it to wheels that are
     * to stand still.
     */
    private static final float LEAST_ACCELERATION = 1;

    private final boolean endless;
    private float start;
    private final float startVelocity;
    private final float velocity;
    private final float rampUp;
    private final float rampDown;
    private float atCruise;
    private float atBraking;
    private float target;
    private final int cruiseMillis;
    private final int brakingMillis;
    private final int endMillis;

    private MovePlan(float p, float u, float v, float a1, float a3, float s1, float s2, float end, int t1, int t2,
            int t3, boolean endless) {
        start = p;
        startVelocity = u;
        velocity = v;
        rampUp = a1;
        rampDown = a3;
        atCruise = p + s1;
        atBraking = p + s1 + s2;
        target = end;
        cruiseMillis = t1;
        brakingMillis = t2;
        endMillis = t3;
        this.endless = endless;
    }

    /** Standing still at a position. */
    static MovePlan rest(float position) {
        return stop(position, 0, 1);
    }

    /** Plans a request from position p with velocity u. */
    static MovePlan of(MoveRequest request, float p, float u) {
        float v = request.speedDegreesPerSecond();
        float a = Math.max(LEAST_ACCELERATION, request.accelerationDegreesPerSecondSquared());
        if (v == 0 || Float.isNaN(v)) {
            return stop(p, u, a);
        }
        int limit = request.limitDegrees();
        if (limit == MotorRegulation.NO_LIMIT || limit == -MotorRegulation.NO_LIMIT) {
            return endless(p, u, limit < 0 ? -v : v, a);
        }
        return limited(p, u, v, a, limit);
    }

    private static MovePlan stop(float p, float u, float a) {
        int duration = (int) (Math.abs(u) / a * MILLIS);
        float braking = u < 0 ? -a : a;
        return new MovePlan(p, u, u, 0, braking, 0, 0, p + u * Math.abs(u) / (2 * a), 0, 0, duration, false);
    }

    private static MovePlan endless(float p, float u, float v, float a) {
        float a1 = v < u ? -a : a;
        int t1 = (int) ((v - u) / a1 * MILLIS);
        float s1 = (v * v - u * u) / (2 * a1);
        return new MovePlan(p, u, v, a1, 0, s1, 0, Float.NaN, t1, Integer.MAX_VALUE, Integer.MAX_VALUE, true);
    }

    private static MovePlan limited(float p, float u, float speed, float a, float limit) {
        float length = limit - p;
        float stopping = u * Math.abs(u) / (2 * a);
        boolean forward = u == 0 ? length >= 0 : length >= stopping;
        float v = forward ? speed : -speed;
        float a1 = v < u ? -a : a;
        float a3 = forward ? a : -a;
        float peakSquared = a3 * length + u * u / 2;
        float s1;
        float s2 = 0;
        if (peakSquared <= v * v) {
            float peak = (float) StrictMath.sqrt(Math.max(0, peakSquared));
            v = forward ? peak : -peak;
            a1 = v < u ? -a : a;
            s1 = (v * v - u * u) / (2 * a1);
        } else {
            s1 = (v * v - u * u) / (2 * a1);
            s2 = length - s1 - v * v / (2 * a3);
        }
        int t1 = (int) ((v - u) / a1 * MILLIS);
        int t2 = t1 + (s2 == 0 ? 0 : (int) (s2 / v * MILLIS));
        int t3 = t2 + (int) (v / a3 * MILLIS);
        return new MovePlan(p, u, v, a1, a3, s1, s2, limit, t1, t2, t3, false);
    }

    /** Position after some milliseconds. */
    float position(double millis) {
        if (millis >= endMillis && !endless) {
            return target;
        }
        if (millis < cruiseMillis) {
            float t = (float) (millis / MILLIS);
            return start + startVelocity * t + rampUp * t * t / 2;
        }
        if (millis < brakingMillis || endless) {
            return (float) (atCruise + velocity * (millis - cruiseMillis) / MILLIS);
        }
        float t = (float) ((millis - brakingMillis) / MILLIS);
        return atBraking + velocity * t - rampDown * t * t / 2;
    }

    /** Velocity after some milliseconds. */
    float velocity(double millis) {
        if (millis < cruiseMillis) {
            return startVelocity + rampUp * (float) (millis / MILLIS);
        }
        if (millis < brakingMillis || endless) {
            return velocity;
        }
        return millis < endMillis ? velocity - rampDown * (float) ((millis - brakingMillis) / MILLIS) : 0;
    }

    /** Time at which the requested or highest velocity is reached. */
    int cruiseMillis() {
        return cruiseMillis;
    }

    /** Time at which slowing down begins; {@link Integer#MAX_VALUE} for a move without end. */
    int brakingMillis() {
        return brakingMillis;
    }

    /** Time at which the target is reached; {@link Integer#MAX_VALUE} for a move without end. */
    int endMillis() {
        return endMillis;
    }

    /** Whether nothing moves at all. */
    boolean empty() {
        return endMillis == 0;
    }

    /** Where the move ends; not a number for a move without end. */
    float target() {
        return target;
    }

    /** Moves the origin of all positions: what was {@code degrees} becomes 0. */
    void shift(int degrees) {
        start -= degrees;
        atCruise -= degrees;
        atBraking -= degrees;
        target -= degrees;
    }
}
