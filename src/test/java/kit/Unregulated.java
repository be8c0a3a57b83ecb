package kit;

import lejos.hardware.motor.UnregulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.utility.Delay;

/** A motor driven with raw power. */
public final class Unregulated {
    private static final UnregulatedMotor MOTOR = new UnregulatedMotor(MotorPort.A);

    private Unregulated() {}

    public static void main(String[] args) {
        System.out.println("initial " + MOTOR.getPower() + " " + MOTOR.isMoving());
        MOTOR.setPower(50);
        Delay.msDelay(300);
        System.out.println("powered " + MOTOR.isMoving() + " " + (MOTOR.getTachoCount() > 20));
        MOTOR.stop();
        Delay.msDelay(500);
        for (int power : new int[] {5, 25, 50, 100}) {
            MOTOR.setPower(power);
            MOTOR.forward();
            Delay.msDelay(1000);
            System.out.println("speed" + power + " " + speed());
            MOTOR.stop();
            Delay.msDelay(500);
        }
        MOTOR.setPower(100);
        MOTOR.backward();
        Delay.msDelay(1000);
        System.out.println("backward " + speed());
        runOut("brake", true);
        MOTOR.forward();
        Delay.msDelay(1000);
        runOut("coast", false);
        MOTOR.resetTachoCount();
        System.out.println("reset " + MOTOR.getTachoCount());
        MOTOR.close();
    }

    /** Degrees per second, averaged over half a second. */
    private static int speed() {
        int before = MOTOR.getTachoCount();
        Delay.msDelay(500);
        return 2 * (MOTOR.getTachoCount() - before);
    }

    private static void runOut(String name, boolean brake) {
        int before = MOTOR.getTachoCount();
        if (brake) {
            MOTOR.stop();
        } else {
            MOTOR.flt();
        }
        Delay.msDelay(1500);
        System.out.println(name + " " + Math.abs(MOTOR.getTachoCount() - before));
    }
}
