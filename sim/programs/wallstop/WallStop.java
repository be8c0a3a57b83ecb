package wallstop;

import lejos.hardware.Sound;
import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;

/** Drives at a wall and stops 30 cm before it, polling the sensor without any pause. */
public class WallStop {
    public static void main(String[] args) {
        EV3UltrasonicSensor sonar = new EV3UltrasonicSensor(SensorPort.S4);
        SampleProvider distance = sonar.getMode("Distance");
        float[] sample = new float[distance.sampleSize()];
        Motor.B.setSpeed(300);
        Motor.C.setSpeed(300);
        Motor.B.forward();
        Motor.C.forward();
        distance.fetchSample(sample, 0);
        while (sample[0] > 0.30f) {
            distance.fetchSample(sample, 0);
        }
        Motor.B.stop(true);
        Motor.C.stop();
        Sound.beep();
        System.out.println("stopped");
        sonar.close();
    }
}
