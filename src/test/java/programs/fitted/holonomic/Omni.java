package programs.fitted.holonomic;

import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;

/** Three omni wheels: ahead, and a turn on the spot. */
public class Omni {
    RegulatedMotor front = new EV3MediumRegulatedMotor(MotorPort.A);
    RegulatedMotor left = new EV3MediumRegulatedMotor(MotorPort.B);
    RegulatedMotor right = new EV3MediumRegulatedMotor(MotorPort.C);

    public static void main(String[] args) {
        new Omni().drive();
    }

    void drive() {
        Wheel one = WheeledChassis.modelHolonomicWheel(front, 4.8).polarPosition(0, 11);
        Wheel two = WheeledChassis.modelHolonomicWheel(left, 4.8).polarPosition(120, 11);
        Wheel three = WheeledChassis.modelHolonomicWheel(right, 4.8).polarPosition(240, 11);
        Chassis chassis = new WheeledChassis(new Wheel[] {one, two, three}, WheeledChassis.TYPE_HOLONOMIC);
        MovePilot pilot = new MovePilot(chassis);
        pilot.setLinearSpeed(12);
        pilot.setAngularSpeed(50);
        pilot.travel(40);
        pilot.rotate(120);
    }
}
