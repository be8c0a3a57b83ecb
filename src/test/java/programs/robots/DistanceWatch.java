package programs.robots;

import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/** Prints the distance that the ultrasonic sensor on S4 measures in centimetres, each second. */
public class DistanceWatch {
    public static void main(String[] args) {
        SampleProvider distance = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
        float[] sample = new float[1];
        for (int second = 0; second < 4; second++) {
            distance.fetchSample(sample, 0);
            System.out.println(Float.isInfinite(sample[0]) ? "nothing" : String.valueOf(Math.round(sample[0] * 100)));
            Delay.msDelay(1000);
        }
    }
}
