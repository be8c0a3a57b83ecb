package lejos.robotics.chassis;

import lejos.robotics.navigation.Pose;
import lejos.utility.Matrix;

/** Rows of the matrix that turns motions of a robot into motions of its motors. */
final class WheelFactors {
    private static final double FULL_TURN = 360;

    private WheelFactors() {}

    /** A wheel that rolls straight ahead; motor turns per wheel turn, and the place left of the middle. */
    static Matrix differential(double diameter, double gearRatio, double offset, boolean invert) {
        double sign = invert ? -1 : 1;
        double forward = FULL_TURN * gearRatio / (Math.PI * diameter) * sign;
        double turn = -2 * offset * gearRatio / diameter * sign;
        return row(forward, 0, turn);
    }

    /** A wheel with rollers that drives along the heading of a pose; wheel turns per motor turn. */
    static Matrix holonomic(double diameter, double gearRatio, Pose pose, boolean invert) {
        double turnsPerMotorTurn = invert ? -gearRatio : gearRatio;
        double perUnit = FULL_TURN / (Math.PI * diameter * turnsPerMotorTurn);
        double heading = StrictMath.toRadians(pose.getHeading());
        double distance = Math.sqrt((double) pose.getX() * pose.getX() + (double) pose.getY() * pose.getY());
        return row(StrictMath.cos(heading) * perUnit, StrictMath.sin(heading) * perUnit,
                2 * distance / (diameter * turnsPerMotorTurn));
    }

    /** All rows; with {@code flat}, one more that says that nothing moves sideways. */
    static Matrix stack(Wheel[] wheels, boolean flat) {
        Matrix rows = new Matrix(wheels.length + (flat ? 1 : 0), 3);
        for (int i = 0; i < wheels.length; i++) {
            rows.setMatrix(i, i, 0, 2, wheels[i].getFactors());
        }
        if (flat) {
            rows.set(wheels.length, 1, 1);
        }
        return rows;
    }

    /**
     * What turns motions of the motors back into the motion of the robot; with more wheels than needed, the motion that
     * fits best.
     *
     * @throws RuntimeException if the wheels leave a motion undecided
     */
    static Matrix invert(Matrix factors) {
        try {
            if (factors.getRowDimension() == factors.getColumnDimension()) {
                return finite(factors.inverse());
            }
            Matrix transposed = factors.transpose();
            return finite(transposed.times(factors).inverse().times(transposed));
        } catch (RuntimeException e) {
            throw new RuntimeException("Invalid wheel setup: these wheels do not control the robot", e);
        }
    }

    private static Matrix finite(Matrix matrix) {
        for (double value : matrix.getRowPackedCopy()) {
            if (Double.isNaN(value) || Double.isInfinite(value)) {
                throw new ArithmeticException("not finite");
            }
        }
        return matrix;
    }

    private static Matrix row(double x, double y, double rotation) {
        return new Matrix(new double[][] {{x, y, rotation}});
    }
}
