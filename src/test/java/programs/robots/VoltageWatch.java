package programs.robots;

import lejos.hardware.Battery;
import lejos.utility.Delay;

/** Prints the battery's voltage in tenths of a volt, each second. */
public class VoltageWatch {
    public static void main(String[] args) {
        for (int second = 0; second < 3; second++) {
            System.out.println(Math.round(Battery.getVoltage() * 10));
            Delay.msDelay(1000);
        }
    }
}
