package corridor;

import lejos.hardware.Button;
import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3IRSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.SampleProvider;

/** Stays in the middle between two walls: as far from the left as from the right one. */
public class CorridorCentering {
    private static final int CRUISE = 300;
    private static final float GAIN = 500;
    private static final int GREATEST_TURN = 140;
    /** Walls farther away than this do not count, metres. */
    private static final float FAR = 0.5f;
    /** Part of the infrared sensor's range in which something ahead is in the way. */
    private static final int NEAR = 30;

    public static void main(String[] args) {
        SampleProvider left = new EV3UltrasonicSensor(SensorPort.S1).getDistanceMode();
        SampleProvider right = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
        SampleProvider ahead = new EV3IRSensor(SensorPort.S2).getDistanceMode();
        RegulatedMotor leftWheel = Motor.B;
        RegulatedMotor rightWheel = Motor.C;
        float[] sample = new float[3];

        while (Button.ESCAPE.isUp()) {
            left.fetchSample(sample, 0);
            right.fetchSample(sample, 1);
            ahead.fetchSample(sample, 2);
            float toTheRight = Math.min(FAR, sample[1]) - Math.min(FAR, sample[0]);
            float turn = Math.max(-GREATEST_TURN, Math.min(GREATEST_TURN, GAIN * toTheRight));
            int cruise = CRUISE;
            if (sample[2] < NEAR) {
                cruise = CRUISE / 2;
                turn = toTheRight >= 0 ? GREATEST_TURN : -GREATEST_TURN;
            }
            leftWheel.setSpeed(Math.round(cruise + turn));
            rightWheel.setSpeed(Math.round(cruise - turn));
            leftWheel.forward();
            rightWheel.forward();
        }
    }
}
