package linefollower;

import lejos.hardware.Button;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.robotics.SampleProvider;

/** Follows the left edge of a dark line with a proportional controller that polls as fast as it can. */
public class LineFollower {
    private static final float EDGE = 0.40f;
    private static final int CRUISE = 200;
    private static final float GAIN = 420;

    public static void main(String[] args) {
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
        EV3ColorSensor eye = new EV3ColorSensor(SensorPort.S3);
        SampleProvider red = eye.getRedMode();
        float[] sample = new float[red.sampleSize()];

        while (Button.ESCAPE.isUp()) {
            red.fetchSample(sample, 0);
            float error = sample[0] - EDGE;
            int turn = Math.round(GAIN * error);
            left.setSpeed(Math.max(0, CRUISE + turn));
            right.setSpeed(Math.max(0, CRUISE - turn));
            left.forward();
            right.forward();
        }
        left.stop(true);
        right.stop();
    }
}
