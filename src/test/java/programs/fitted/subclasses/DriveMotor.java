package programs.fitted.subclasses;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.Port;

/** A large motor that is careful. */
class DriveMotor extends EV3LargeRegulatedMotor {
    DriveMotor(Port port) {
        super(port);
        setAcceleration(1500);
        setSpeed(300);
    }
}
