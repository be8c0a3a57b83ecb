package kit;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.localization.PoseProvider;
import lejos.robotics.navigation.MovePilot;
import lejos.utility.Delay;

/** A quarter turn, ahead, and two seconds to the left with a holonomic chassis; centimetres. */
public final class HolonomicDrive {
    private HolonomicDrive() {}

    public static void main(String[] args) {
        Wheel[] wheels = {
            WheeledChassis.modelHolonomicWheel(new EV3LargeRegulatedMotor(MotorPort.A), 5.8).polarPosition(60, 9.2),
            WheeledChassis.modelHolonomicWheel(new EV3LargeRegulatedMotor(MotorPort.B), 5.8).polarPosition(-60, 9.2),
            WheeledChassis.modelHolonomicWheel(new EV3LargeRegulatedMotor(MotorPort.C), 5.8).polarPosition(180, 9.2)};
        WheeledChassis chassis = new WheeledChassis(wheels, WheeledChassis.TYPE_HOLONOMIC);
        PoseProvider odometer = chassis.getPoseProvider();
        MovePilot pilot = new MovePilot(chassis);
        pilot.setLinearSpeed(15);
        pilot.setAngularSpeed(90);
        pilot.rotate(90);
        pilot.travel(30);
        chassis.setVelocity(10, 90, 0);
        Delay.msDelay(2000);
        chassis.stop();
        chassis.waitComplete();
        System.out.println("pose " + odometer.getPose().getX() + " " + odometer.getPose().getY() + " "
                + odometer.getPose().getHeading());
        System.exit(0);
    }
}
