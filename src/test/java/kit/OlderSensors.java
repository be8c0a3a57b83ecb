package kit;

import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3IRSensor;
import lejos.hardware.sensor.NXTColorSensor;
import lejos.hardware.sensor.NXTLightSensor;
import lejos.hardware.sensor.NXTUltrasonicSensor;
import lejos.utility.Stopwatch;

/** The infrared sensor and NXT sensors, each in all its modes. */
public final class OlderSensors {
    private OlderSensors() {}

    public static void main(String[] args) {
        infrared();
        light();
        colour();
        ultrasonic();
    }

    private static void infrared() {
        EV3IRSensor sensor = new EV3IRSensor(SensorPort.S1);
        Samples.print("proximity", sensor.getDistanceMode());
        Samples.print("seek", sensor.getSeekMode());
        System.out.println("remote " + sensor.getRemoteCommand(0) + " " + sensor.getRemoteCommand(1));
        Samples.series("proximities", sensor.getDistanceMode(), 20, 60);
    }

    private static void light() {
        NXTLightSensor sensor = new NXTLightSensor(SensorPort.S2);
        Samples.print("lightRed", sensor.getRedMode());
        Samples.print("lightAmbient", sensor.getAmbientMode());
        Samples.series("lights", sensor.getRedMode(), 20, 10);
    }

    private static void colour() {
        Stopwatch watch = new Stopwatch();
        NXTColorSensor sensor = new NXTColorSensor(SensorPort.S3);
        System.out.println("nxtColourStart " + watch.elapsed());
        Samples.print("nxtColorId", sensor.getColorIDMode());
        Samples.print("nxtRgb", sensor.getRGBMode());
    }

    private static void ultrasonic() {
        NXTUltrasonicSensor sensor = new NXTUltrasonicSensor(SensorPort.S4);
        System.out.println("product " + sensor.getVendorID() + " " + sensor.getProductID() + " " + sensor.getVersion());
        Samples.print("centimetres", sensor.getDistanceMode());
        Samples.print("ping", sensor.getPingMode());
        System.out.println("afterPing " + sensor.isEnabled());
        sensor.enable();
        Samples.series("nxtDistances", sensor.getDistanceMode(), 20, 60);
        Stopwatch watch = new Stopwatch();
        for (int i = 0; i < 11; i++) {
            sensor.fetchSample(new float[1], 0);
        }
        System.out.println("nxtFetches " + watch.elapsed());
    }
}
