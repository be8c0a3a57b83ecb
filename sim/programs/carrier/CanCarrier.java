package carrier;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.robotics.Color;
import lejos.robotics.SampleProvider;

/** Fetches a can: drives at it until it stands between the fingers, closes the claw, carries it onto the green patch and lets go. */
public class CanCarrier {
    private static final int CLOSED = 90;
    private static final int OPEN = 0;

    private final EV3MediumRegulatedMotor claw = new EV3MediumRegulatedMotor(MotorPort.A);
    private final EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
    private final EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
    private final SampleProvider touch = new EV3TouchSensor(SensorPort.S1).getTouchMode();
    private final EV3ColorSensor eye = new EV3ColorSensor(SensorPort.S3);
    private final float[] pressed = new float[1];

    public static void main(String[] args) {
        new CanCarrier().run();
    }

    private void run() {
        left.setSpeed(200);
        right.setSpeed(200);
        turnRight(135);
        forward();
        while (!touched()) {
            Thread.yield();
        }
        halt();
        claw.rotateTo(CLOSED);
        System.out.println("got it");
        forward();
        while (eye.getColorID() != Color.GREEN) {
            Thread.yield();
        }
        halt();
        travel(150);
        claw.rotateTo(OPEN);
        travel(-250);
        System.out.println("brought it");
    }

    private boolean touched() {
        touch.fetchSample(pressed, 0);
        return pressed[0] == 1;
    }

    private void forward() {
        left.forward();
        right.forward();
    }

    private void halt() {
        left.stop(true);
        right.stop();
    }

    private void travel(int millimetres) {
        move(millimetres * 360 / 176, millimetres * 360 / 176);
    }

    private void turnRight(int degrees) {
        move(degrees * 120 / 56, -degrees * 120 / 56);
    }

    private void move(int leftDegrees, int rightDegrees) {
        left.rotate(leftDegrees, true);
        right.rotate(rightDegrees);
        left.waitComplete();
    }
}
