package programs.students;

import java.util.Scanner;
import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.MotorPort;

/** Commands from a keyboard: on a brick there is none. */
public class KeyboardReader {
    public static void main(String[] args) {
        System.out.println("arguments " + args.length);
        EV3MediumRegulatedMotor arm = new EV3MediumRegulatedMotor(MotorPort.A);
        Scanner scanner = new Scanner(System.in);
        int commands = 0;
        while (scanner.hasNextLine()) {
            String line = scanner.nextLine().trim().toLowerCase();
            commands++;
            if (line.equals("up")) {
                arm.rotateTo(90);
            } else if (line.equals("down")) {
                arm.rotateTo(0);
            }
        }
        System.out.println("commands " + commands);
        arm.close();
    }
}
