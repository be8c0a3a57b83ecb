package programs.fitted.sensors;

import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.motor.NXTRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.Port;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3GyroSensor;
import lejos.hardware.sensor.NXTLightSensor;
import lejos.hardware.sensor.NXTTouchSensor;
import lejos.hardware.sensor.NXTUltrasonicSensor;
import lejos.robotics.SampleProvider;
import lejos.robotics.filter.MeanFilter;

/** An NXT kit on an EV3 with a gyro: turns left by the gyro, then drives until the wall is near. */
public class Detector {
    private static final Port GYRO = SensorPort.S3;

    private final NXTRegulatedMotor right = new NXTRegulatedMotor(MotorPort.A);
    private final NXTRegulatedMotor left = new NXTRegulatedMotor(MotorPort.B);
    private final SampleProvider sonar = new MeanFilter(new NXTUltrasonicSensor(SensorPort.S1).getDistanceMode(), 3);
    private final SampleProvider angle = new EV3GyroSensor(GYRO).getAngleMode();
    private final NXTLightSensor light = new NXTLightSensor(LocalEV3.get().getPort("S2"));
    private final NXTTouchSensor bump = new NXTTouchSensor(LocalEV3.get().getPort("S4"));
    private final float[] sample = new float[1];

    public static void main(String[] args) {
        new Detector().run();
    }

    private float read(SampleProvider provider) {
        provider.fetchSample(sample, 0);
        return sample[0];
    }

    private void run() {
        left.setSpeed(100);
        right.setSpeed(100);
        right.forward();
        left.backward();
        while (read(angle) < 88) {
            Thread.yield();
        }
        right.setSpeed(300);
        left.setSpeed(300);
        left.forward();
        right.forward();
        while (read(sonar) > 0.30 && read(bump.getTouchMode()) == 0) {
            Thread.yield();
        }
        left.stop(true);
        right.stop();
        System.out.println(read(light.getRedMode()) > 0.5 ? "bright" : "dark");
    }
}
