package programs.fitted.constants;

import lejos.hardware.motor.EV3LargeRegulatedMotor;

/** Three sides of a square of 60.96 cm, to the right. */
class SquareDriver {
    private static final int FORWARD_SPEED = 250;
    private static final int ROTATE_SPEED = 150;

    static void drive(EV3LargeRegulatedMotor leftMotor, EV3LargeRegulatedMotor rightMotor, double leftRadius,
            double rightRadius, double width) {
        for (int i = 0; i < 3; i++) {
            leftMotor.setSpeed(FORWARD_SPEED);
            rightMotor.setSpeed(FORWARD_SPEED);
            leftMotor.rotate(convertDistance(leftRadius, 60.96), true);
            rightMotor.rotate(convertDistance(rightRadius, 60.96), false);
            leftMotor.setSpeed(ROTATE_SPEED);
            rightMotor.setSpeed(ROTATE_SPEED);
            leftMotor.rotate(convertAngle(leftRadius, width, 90.0), true);
            rightMotor.rotate(-convertAngle(rightRadius, width, 90.0), false);
        }
    }

    private static int convertDistance(double radius, double distance) {
        return (int) ((180.0 * distance) / (Math.PI * radius));
    }

    private static int convertAngle(double radius, double width, double angle) {
        return convertDistance(radius, Math.PI * width * angle / 360.0);
    }
}
