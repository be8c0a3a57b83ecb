package programs.fitted.subclasses;

import lejos.hardware.port.MotorPort;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;

/** The pilot of this robot. */
class Drive extends MovePilot {
    Drive() {
        super(new WheeledChassis(new Wheel[] {wheel(new DriveMotor(MotorPort.B), -6.9),
                wheel(new DriveMotor(MotorPort.A), 6.9)}, WheeledChassis.TYPE_DIFFERENTIAL));
        setLinearSpeed(10);
        setAngularSpeed(50);
    }

    private static Wheel wheel(DriveMotor motor, double offset) {
        return WheeledChassis.modelWheel(motor, 4.32).offset(offset);
    }
}
