package programs.fitted.mediums;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.MotorPort;

/** Two medium motors drive, a large one lifts a fork. */
public class LiftTruck {
    static EV3MediumRegulatedMotor[] drive = {new EV3MediumRegulatedMotor(MotorPort.A),
            new EV3MediumRegulatedMotor(MotorPort.B)};
    static EV3LargeRegulatedMotor fork = new EV3LargeRegulatedMotor(MotorPort.C);
    static double wheelDiameterInMm = 68.8;

    public static void main(String[] args) {
        fork.rotate(-90);
        forward(600);
        fork.rotateTo(0);
        forward(-200);
        System.out.println(fork.getTachoCount());
    }

    static void forward(double mm) {
        int degrees = (int) Math.round(mm / (Math.PI * wheelDiameterInMm) * 360);
        drive[0].synchronizeWith(new EV3MediumRegulatedMotor[] {drive[1]});
        drive[0].startSynchronization();
        for (EV3MediumRegulatedMotor motor : drive) {
            motor.setSpeed(400);
            motor.rotate(degrees, true);
        }
        drive[0].endSynchronization();
        for (EV3MediumRegulatedMotor motor : drive) {
            motor.waitComplete();
        }
    }
}
