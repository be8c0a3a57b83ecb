package programs.robots;

import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.NXTSoundSensor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** Prints when it gets loud and quiet. */
public class SoundWatch {
    public static void main(String[] args) {
        SampleProvider level = new NXTSoundSensor(SensorPort.S2).getDBMode();
        float[] sample = new float[1];
        Stopwatch watch = new Stopwatch();
        boolean before = false;
        while (watch.elapsed() < 3000) {
            level.fetchSample(sample, 0);
            boolean loud = sample[0] > 0.5f;
            if (loud != before) {
                System.out.println(loud ? "loud" : "quiet");
            }
            before = loud;
            Delay.msDelay(5);
        }
    }
}
