package kit;

import lejos.hardware.motor.Motor;

/** Does nothing but blocking moves. */
public final class OnlyRotates {
    private OnlyRotates() {}

    public static void main(String[] args) {
        for (int i = 0; i < 20; i++) {
            Motor.B.rotate(90);
            Motor.C.rotate(90, true);
            Motor.B.rotate(90);
            Motor.C.waitComplete();
        }
    }
}
