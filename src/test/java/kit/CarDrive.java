package kit;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.SteeringPilot;

/** A car's pilot with motors that turn for real; the steering has ends to be felt. Centimetres. */
public final class CarDrive implements MoveListener {
    private CarDrive() {}

    public static void main(String[] args) {
        EV3LargeRegulatedMotor drive = new EV3LargeRegulatedMotor(MotorPort.A);
        EV3MediumRegulatedMotor steering = new EV3MediumRegulatedMotor(MotorPort.D);
        SteeringPilot pilot = new SteeringPilot(5.6, drive, steering, 20, 10, -10);
        pilot.addMoveListener(new CarDrive());
        pilot.calibrateSteering();
        System.out.println("straight " + steering.getTachoCount());
        pilot.arc(25, 90);
        System.out.println("left " + steering.getTachoCount() + " " + drive.getTachoCount());
        pilot.travelArc(-25, -10);
        System.out.println("right " + steering.getTachoCount() + " " + drive.getTachoCount());
        pilot.travel(10);
        System.out.println("ahead " + steering.getTachoCount() + " " + drive.getTachoCount());
        pilot.arcForward(20);
        System.out.println("moving " + (pilot.isMoving() ? 1 : 0));
        pilot.stop();
        System.out.println("stopped " + (pilot.isMoving() ? 1 : 0));
    }

    @Override
    public void moveStarted(Move event, MoveProvider provider) {
        System.out.println("started");
    }

    @Override
    public void moveStopped(Move event, MoveProvider provider) {
        System.out.println("driven." + event.getMoveType() + " " + event.getDistanceTraveled());
    }
}
