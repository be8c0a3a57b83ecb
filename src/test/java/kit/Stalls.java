package kit;

import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import lejos.utility.Stopwatch;

/** A claw driven against its stop. */
public final class Stalls implements RegulatedMotorListener {
    private Stalls() {}

    public static void main(String[] args) {
        EV3MediumRegulatedMotor claw = new EV3MediumRegulatedMotor(MotorPort.D);
        claw.addListener(new Stalls());
        claw.rotate(90);
        System.out.println("free " + claw.isStalled());
        push(claw, "default");
        claw.rotateTo(20);
        System.out.println("freed " + claw.isStalled() + " " + claw.getTachoCount());
        claw.setStallThreshold(10, 200);
        push(claw, "quick");
        push(claw, "again");
    }

    private static void push(EV3MediumRegulatedMotor claw, String name) {
        Stopwatch watch = new Stopwatch();
        claw.rotateTo(1000);
        System.out.println(name + " " + watch.elapsed() + " " + claw.isStalled() + " " + claw.isMoving() + " "
                + claw.getTachoCount());
    }

    @Override
    public void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {
        System.out.println("started moving=" + motor.isMoving());
    }

    @Override
    public void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {
        System.out.println("stopped stalled=" + stalled);
    }
}
