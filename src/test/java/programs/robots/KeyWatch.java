package programs.robots;

import lejos.hardware.Button;

/** Waits for three keys and prints which they were. */
public class KeyWatch {
    public static void main(String[] args) {
        for (int i = 0; i < 3; i++) {
            System.out.println(Button.waitForAnyPress());
        }
    }
}
