package programs.robots;

import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3IRSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/**
 * Looks down with a colour sensor on S1, and ahead with an infrared sensor on S2 and an ultrasonic one on S4, for ever.
 */
public class ManyEyes {
    public static void main(String[] args) {
        SampleProvider[] eyes = {
            new EV3ColorSensor(SensorPort.S1).getRGBMode(), new EV3IRSensor(SensorPort.S2).getDistanceMode(),
            new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode()
        };
        float[] sample = new float[3];
        while (true) {
            for (SampleProvider eye : eyes) {
                eye.fetchSample(sample, 0);
            }
            Delay.msDelay(30);
        }
    }
}
