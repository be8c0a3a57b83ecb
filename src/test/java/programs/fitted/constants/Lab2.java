package programs.fitted.constants;

import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.motor.EV3LargeRegulatedMotor;

/** A robotics course: wheel radius and track in constants, motors of the local brick, a driver class of its own. */
public class Lab2 {
    public static final double WHEEL_RADIUS = 2.15;
    public static final double TRACK = 15.6;

    private static final EV3LargeRegulatedMotor leftMotor = new EV3LargeRegulatedMotor(LocalEV3.get().getPort("A"));
    private static final EV3LargeRegulatedMotor rightMotor = new EV3LargeRegulatedMotor(LocalEV3.get().getPort("D"));

    public static void main(String[] args) {
        for (EV3LargeRegulatedMotor motor : new EV3LargeRegulatedMotor[] {leftMotor, rightMotor}) {
            motor.stop();
            motor.setAcceleration(3000);
        }
        new Thread() {
            public void run() {
                SquareDriver.drive(leftMotor, rightMotor, WHEEL_RADIUS, WHEEL_RADIUS, TRACK);
            }
        }.start();
    }
}
