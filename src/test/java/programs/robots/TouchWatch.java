package programs.robots;

import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** Prints when the touch sensor on S1 changes. */
public class TouchWatch {
    public static void main(String[] args) {
        Stopwatch watch = new Stopwatch();
        EV3TouchSensor touch = new EV3TouchSensor(SensorPort.S1);
        float[] sample = new float[1];
        float before = 0;
        while (watch.elapsed() < 4000) {
            touch.fetchSample(sample, 0);
            if (sample[0] != before) {
                System.out.println((sample[0] > 0 ? "pressed " : "released ") + watch.elapsed() / 100);
            }
            before = sample[0];
            Delay.msDelay(5);
        }
    }
}
