package beacon;

import lejos.hardware.Sound;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3IRSensor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/** Drives to the infrared beacon on channel 1. Out of its sight it looks round, and goes on until it sees it. */
public class BeaconSeeker {
    private static final int CRUISE = 300;
    /** Distances are in percent of about two metres. */
    private static final float ARRIVED = 8;
    private static final float FAR = 100;
    private static final float WALL = 35;

    private final EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
    private final EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
    private final EV3IRSensor eye = new EV3IRSensor(SensorPort.S4);
    private final SampleProvider seek = eye.getSeekMode();
    private final SampleProvider proximity = eye.getDistanceMode();
    private final float[] beacons = new float[seek.sampleSize()];
    private final float[] distance = new float[1];

    public static void main(String[] args) {
        new BeaconSeeker().run();
    }

    private void run() {
        while (true) {
            if (!sees() && !lookRound()) {
                goOn();
            } else if (beacons[1] < ARRIVED) {
                left.stop(true);
                right.stop();
                System.out.println("home");
                Sound.twoBeeps();
                return;
            } else {
                drive(CRUISE + Math.round(6 * beacons[0]), CRUISE - Math.round(6 * beacons[0]));
            }
        }
    }

    private boolean sees() {
        seek.fetchSample(beacons, 0);
        return beacons[1] <= FAR;
    }

    /** Turns once round on the spot, or until the beacon is in sight. */
    private boolean lookRound() {
        left.setSpeed(CRUISE / 2);
        right.setSpeed(CRUISE / 2);
        left.rotate(-772, true);
        right.rotate(772, true);
        while (left.isMoving()) {
            if (sees()) {
                left.stop(true);
                right.stop();
                return true;
            }
            Delay.msDelay(50);
        }
        return false;
    }

    /** Forty centimetres ahead; before a wall, a quarter turn to the left. */
    private void goOn() {
        left.resetTachoCount();
        drive(CRUISE, CRUISE);
        do {
            proximity.fetchSample(distance, 0);
        } while (distance[0] > WALL && left.getTachoCount() < 820);
        left.stop(true);
        right.stop();
        if (distance[0] <= WALL) {
            left.rotate(-193, true);
            right.rotate(193);
            left.waitComplete();
        }
    }

    private void drive(int leftSpeed, int rightSpeed) {
        left.setSpeed(leftSpeed);
        right.setSpeed(rightSpeed);
        left.forward();
        right.forward();
    }
}
