package maze;

import lejos.hardware.Button;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;

/** Keeps its right hand on the wall: one ultrasonic sensor looks to the right, one ahead. For mazes with cells of 35 cm. */
public class MazeSolver {
    /** Motor degrees per millimetre: tyres of 56 mm. */
    private static final double DEGREES_PER_MM = 360 / (Math.PI * 56);
    /** Half the distance between the wheels. */
    private static final double HALF_TRACK_MM = 60;

    private static final float OPEN = 0.28f;
    private static final float BLOCKED = 0.085f;
    private static final float KEEP = 0.112f;
    private static final int CRUISE = 300;
    /** From where the end of a wall is seen to the middle of the cell behind it; less after a turn into a new cell. */
    private static final int TO_MIDDLE = 190;
    private static final int INTO_CELL = 240;
    private static final int TO_MIDDLE_AFTER_TURN = 350 - INTO_CELL;

    private final EV3LargeRegulatedMotor leftWheel = new EV3LargeRegulatedMotor(MotorPort.B);
    private final EV3LargeRegulatedMotor rightWheel = new EV3LargeRegulatedMotor(MotorPort.C);
    private final SampleProvider ahead = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
    private final SampleProvider right = new EV3UltrasonicSensor(SensorPort.S1).getDistanceMode();
    private final float[] sample = new float[1];

    public static void main(String[] args) {
        new MazeSolver().solve();
    }

    private void solve() {
        int toMiddle = TO_MIDDLE;
        while (Button.ESCAPE.isUp()) {
            float wall = read(right);
            if (wall > OPEN) {
                travel(toMiddle);
                turnRight(90);
                travel(INTO_CELL);
                toMiddle = TO_MIDDLE_AFTER_TURN;
            } else if (read(ahead) < BLOCKED) {
                turnRight(-90);
                toMiddle = TO_MIDDLE;
            } else {
                follow(wall);
                toMiddle = TO_MIDDLE;
            }
        }
    }

    private float read(SampleProvider sensor) {
        sensor.fetchSample(sample, 0);
        return sample[0];
    }

    private void follow(float wall) {
        int turn = Math.round(Math.max(-80, Math.min(80, 1200 * (wall - KEEP))));
        leftWheel.setSpeed(CRUISE + turn);
        rightWheel.setSpeed(CRUISE - turn);
        leftWheel.forward();
        rightWheel.forward();
    }

    private void travel(int millimetres) {
        move(millimetres, millimetres);
    }

    private void turnRight(int degrees) {
        double arc = Math.toRadians(degrees) * HALF_TRACK_MM;
        move(arc, -arc);
    }

    private void move(double left, double right) {
        leftWheel.setSpeed(CRUISE);
        rightWheel.setSpeed(CRUISE);
        leftWheel.rotate((int) Math.round(left * DEGREES_PER_MM), true);
        rightWheel.rotate((int) Math.round(right * DEGREES_PER_MM), true);
        leftWheel.waitComplete();
        rightWheel.waitComplete();
    }
}
