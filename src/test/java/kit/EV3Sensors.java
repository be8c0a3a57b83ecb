package kit;

import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3GyroSensor;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.Color;
import lejos.utility.Stopwatch;

/** The sensors of the educator set, each in all its modes. */
public final class EV3Sensors {
    private EV3Sensors() {}

    public static void main(String[] args) {
        Stopwatch watch = new Stopwatch();
        EV3TouchSensor touch = new EV3TouchSensor(SensorPort.S1);
        System.out.println("touchStart " + watch.elapsed());
        Samples.print("touch", touch.getTouchMode());
        ultrasonic();
        colour();
        gyro();
    }

    private static void ultrasonic() {
        Stopwatch watch = new Stopwatch();
        EV3UltrasonicSensor sensor = new EV3UltrasonicSensor(SensorPort.S4);
        System.out.println("ultrasonicStart " + watch.elapsed());
        Samples.print("distance", sensor.getDistanceMode());
        watch.reset();
        sensor.getListenMode().fetchSample(new float[1], 0);
        System.out.println("ultrasonicSwitch " + watch.elapsed());
        Samples.print("listen", sensor.getListenMode());
        sensor.disable();
        System.out.println("disabled " + sensor.isEnabled());
        Samples.print("again", sensor);
        System.out.println("enabled " + sensor.isEnabled());
        Samples.series("distances", sensor, 20, 40);
        Samples.updates("distanceUpdates", sensor);
    }

    private static void colour() {
        EV3ColorSensor sensor = new EV3ColorSensor(SensorPort.S3);
        System.out.println("lampAtStart " + (sensor.getFloodlight() == Color.RED));
        Samples.print("colorId", sensor.getColorIDMode());
        Samples.print("red", sensor.getRedMode());
        Samples.print("rgb", sensor.getRGBMode());
        Samples.print("ambient", sensor.getAmbientMode());
        Stopwatch watch = new Stopwatch();
        sensor.getRedMode().fetchSample(new float[1], 0);
        System.out.println("colourSwitch " + watch.elapsed());
        Samples.series("reds", sensor.getRedMode(), 20, 10);
        sensor.setFloodlight(false);
        System.out.println("lampOff " + sensor.isFloodlightOn());
    }

    private static void gyro() {
        EV3GyroSensor sensor = new EV3GyroSensor(SensorPort.S2);
        Samples.print("angle", sensor.getAngleMode());
        Samples.print("rate", sensor.getRateMode());
        Samples.print("both", sensor.getAngleAndRateMode());
        Samples.series("rates", sensor.getRateMode(), 20, 10);
        Stopwatch watch = new Stopwatch();
        sensor.reset();
        System.out.println("gyroReset " + watch.elapsed());
    }
}
