package kit;

import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.robotics.navigation.OmniPilot;

/** Ahead, to the left, and a quarter turn on three omnidirectional wheels, with the older pilot; centimetres. */
public final class OmniDrive {
    private OmniDrive() {}

    @SuppressWarnings("deprecation")
    public static void main(String[] args) {
        EV3LargeRegulatedMotor rear = new EV3LargeRegulatedMotor(MotorPort.C);
        EV3LargeRegulatedMotor frontLeft = new EV3LargeRegulatedMotor(MotorPort.A);
        EV3LargeRegulatedMotor frontRight = new EV3LargeRegulatedMotor(MotorPort.B);
        OmniPilot pilot = new OmniPilot(9.2f, 5.8f, rear, frontLeft, frontRight, false, true,
                LocalEV3.get().getPower());
        pilot.setLinearSpeed(15);
        pilot.travel(30);
        pilot.travel(20, 90.0);
        pilot.rotate(90);
        System.out.println("moving " + pilot.isMoving());
        System.exit(0);
    }
}
