package programs.speed;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.robotics.SampleProvider;

/** Follows the edge of a line for ever, polling its colour sensor without any pause. */
public class LinePoller {
    private static final float EDGE = 0.40f;
    private static final int CRUISE = 200;
    private static final float GAIN = 420;

    /** Runs for ever. */
    public static void main(String[] args) {
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
        SampleProvider red = new EV3ColorSensor(SensorPort.S3).getRedMode();
        float[] sample = new float[1];
        left.forward();
        right.forward();
        while (true) {
            red.fetchSample(sample, 0);
            int turn = Math.round(GAIN * (sample[0] - EDGE));
            left.setSpeed(Math.max(0, CRUISE + turn));
            right.setSpeed(Math.max(0, CRUISE - turn));
            left.forward();
            right.forward();
        }
    }
}
