package programs.students;

import java.text.DecimalFormat;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lejos.hardware.Brick;
import lejos.hardware.BrickFinder;
import lejos.hardware.lcd.Font;
import lejos.hardware.lcd.TextLCD;
import lejos.hardware.port.Port;
import lejos.hardware.sensor.BaseSensor;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3GyroSensor;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;

/** Shows every mode of every sensor in small letters. */
public class Dashboard {
    interface Maker {
        BaseSensor make(Port port);
    }

    public static void main(String[] args) throws Exception {
        Brick brick = BrickFinder.getDefault();
        TextLCD lcd = brick.getTextLCD(Font.getSmallFont());
        Map<String, Maker> plugged = new LinkedHashMap<>();
        plugged.put("S1", EV3TouchSensor::new);
        plugged.put("S2", EV3GyroSensor::new);
        plugged.put("S3", EV3ColorSensor::new);
        plugged.put("S4", EV3UltrasonicSensor::new);
        List<BaseSensor> sensors = new ArrayList<>();
        plugged.forEach((name, maker) -> sensors.add(maker.make(brick.getPort(name))));
        DecimalFormat format = new DecimalFormat("0.00");
        int row = 0;
        for (BaseSensor sensor : sensors) {
            String type = sensor.getClass().getSimpleName();
            for (String modeName : sensor.getAvailableModes()) {
                SampleProvider mode = sensor.getMode(modeName);
                float[] sample = new float[mode.sampleSize()];
                mode.fetchSample(sample, 0);
                String values = "";
                for (float value : sample) {
                    values += " " + (Float.isInfinite(value) ? "inf" : format.format(value));
                }
                lcd.drawString(modeName + values, 0, row++);
            }
            System.out.println(type + " " + sensor.getAvailableModes() + " " + sensor.getModeCount());
        }
        System.out.println(Arrays.toString(new int[] {row, lcd.getTextWidth(), lcd.getTextHeight()}));
        for (BaseSensor sensor : sensors) {
            sensor.close();
        }
        Thread.sleep(1000);
    }
}
