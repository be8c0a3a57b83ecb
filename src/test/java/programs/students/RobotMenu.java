package programs.students;

import lejos.hardware.Battery;
import lejos.hardware.Button;
import lejos.hardware.Sound;
import lejos.hardware.lcd.LCD;
import lejos.hardware.motor.Motor;
import lejos.utility.Delay;
import lejos.utility.TextMenu;

/** A menu of small demonstrations; ESCAPE ends it. */
public class RobotMenu {

    static String[] items = {"Beep", "Battery", "Wiggle", "Count down", "Exit"};
    static int beeps = 0;

    public static void main(String[] args) throws InterruptedException {
        TextMenu menu = new TextMenu(items, 1, "What shall I do?");
        boolean running = true;
        int selection = 0;
        while (running) {
            LCD.clear();
            selection = menu.select(selection);
            LCD.clear();
            switch (selection) {
                case 0:
                    beeps = beeps + 1;
                    Sound.beep();
                    break;
                case 1:
                    showBattery();
                    break;
                case 2:
                    wiggle();
                    break;
                case 3:
                    for (int i = 3; i > 0; i--) {
                        LCD.drawInt(i, 3, 7, 3);
                        Sound.playTone(400 + 100 * i, 100);
                        Thread.sleep(400);
                    }
                    break;
                default:
                    running = false;
            }
        }
        LCD.drawString("Bye", 7, 3);
        System.out.println("chose " + selection + " after " + beeps + " beeps");
        Delay.msDelay(500);
    }

    private static void showBattery() {
        float volts = Battery.getVoltage();
        LCD.drawString("Battery", 0, 0);
        LCD.drawString(String.format("%.1f V", volts), 0, 1);
        if (volts < 6.5) {
            Sound.buzz();
        }
        System.out.println(Battery.getVoltageMilliVolt() == (int) (volts * 1000f) ? "same voltage" : "other voltage");
        Button.ENTER.waitForPressAndRelease();
    }

    private static void wiggle() {
        Motor.B.setSpeed(300);
        Motor.C.setSpeed(300);
        for (int i = 0; i < 2; i++) {
            Motor.B.rotate(60, true);
            Motor.C.rotate(-60);
            Motor.B.rotate(-60, true);
            Motor.C.rotate(60);
        }
        System.out.println("wiggled to " + Motor.B.getTachoCount() / 10 + " and " + Motor.C.getTachoCount() / 10);
    }
}
