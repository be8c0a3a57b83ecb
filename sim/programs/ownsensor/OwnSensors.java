import lejos.hardware.Button;
import lejos.hardware.Sound;
import lejos.hardware.lcd.LCD;
import lejos.hardware.port.SensorPort;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/** Reads four sensors through drivers of its own, one for each way of talking to a sensor. Run it with --robot robot.svg. */
public class OwnSensors {
    public static void main(String[] args) {
        Sonar sonar = new Sonar(SensorPort.S4);
        Ranger ranger = new Ranger(SensorPort.S3);
        Lamp lamp = new Lamp(SensorPort.S2);
        Bumper bumper = new Bumper(SensorPort.S1);
        LCD.drawString(ranger.getVendorID() + " " + ranger.getProductID() + " " + ranger.getVersion(), 0, 7);
        for (int round = 0; round < 20 && Button.ESCAPE.isUp(); round++) {
            show("sonar mm", sonar, 0);
            show("sonar in", sonar.getMode("Inches"), 1);
            show("ranger m", ranger, 2);
            show("bright", lamp.getMode("Bright"), 3);
            show("dark", lamp.getMode("Dark"), 4);
            show("bumper", bumper, 5);
            Delay.msDelay(50);
        }
        Sound.beep();
        sonar.close();
        ranger.close();
        lamp.close();
        bumper.close();
        LCD.drawString("closed", 0, 6);
    }

    private static void show(String name, SampleProvider source, int row) {
        float[] sample = new float[source.sampleSize()];
        source.fetchSample(sample, 0);
        LCD.drawString(name + " " + sample[0] + "      ", 0, row);
    }
}
