package kit;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.robotics.RegulatedMotor;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** Two wheels that start, run and stop together, and one that holds while the other pulls. */
public final class Together {
    private static final EV3LargeRegulatedMotor LEFT = new EV3LargeRegulatedMotor(MotorPort.B);
    private static final EV3LargeRegulatedMotor RIGHT = new EV3LargeRegulatedMotor(MotorPort.C);

    private Together() {}

    public static void main(String[] args) {
        LEFT.synchronizeWith(new RegulatedMotor[] {RIGHT});
        Stopwatch watch = new Stopwatch();
        LEFT.startSynchronization();
        LEFT.rotate(360);
        RIGHT.rotate(360);
        System.out.println("recorded " + watch.elapsed() + " " + LEFT.isMoving() + " " + RIGHT.isMoving());
        LEFT.endSynchronization();
        System.out.println("sent " + LEFT.isMoving() + " " + RIGHT.isMoving());
        int apart = 0;
        while (LEFT.isMoving()) {
            apart = Math.max(apart, Math.abs(LEFT.getTachoCount() - RIGHT.getTachoCount()));
            Delay.msDelay(2);
        }
        System.out.println("apart " + apart + " " + LEFT.getTachoCount() + " " + RIGHT.getTachoCount());
        pull("hold");
        RIGHT.flt();
        pull("float");
    }

    /** The left wheel turns the robot about the right one. */
    private static void pull(String name) {
        RIGHT.resetTachoCount();
        LEFT.rotate(180);
        System.out.println(name + " " + RIGHT.getTachoCount());
        LEFT.rotate(-180);
    }
}
