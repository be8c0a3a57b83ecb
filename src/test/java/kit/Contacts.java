package kit;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.NXTSoundSensor;
import lejos.hardware.sensor.NXTTouchSensor;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** Touch and sound sensors: what a hand, a clap and a wall do to them. */
public final class Contacts {
    private static final Stopwatch WATCH = new Stopwatch();

    private Contacts() {}

    public static void main(String[] args) {
        EV3TouchSensor bumper = new EV3TouchSensor(SensorPort.S1);
        NXTTouchSensor button = new NXTTouchSensor(SensorPort.S2);
        NXTSoundSensor ear = new NXTSoundSensor(SensorPort.S3);
        System.out.println("free " + value(bumper) + " " + value(button));
        System.out.println("quiet " + value(ear.getDBMode()) + " " + value(ear.getDBAMode()));
        print("hand", bumper);
        print("handOnTheOther", button);
        print("clap", ear.getDBMode());
        Motor.B.forward();
        Motor.C.forward();
        print("wall", bumper);
        Motor.B.stop(true);
        Motor.C.stop();
        Motor.B.rotate(-180, true);
        Motor.C.rotate(-180);
        System.out.println("backedUp " + value(bumper));
    }

    private static void print(String name, SampleProvider source) {
        while (value(source) < 0.5f) {
            Delay.msDelay(5);
        }
        System.out.println(name + " " + WATCH.elapsed());
        while (value(source) >= 0.5f && !name.equals("wall")) {
            Delay.msDelay(5);
        }
    }

    private static float value(SampleProvider source) {
        float[] sample = new float[source.sampleSize()];
        source.fetchSample(sample, 0);
        return sample[0];
    }
}
