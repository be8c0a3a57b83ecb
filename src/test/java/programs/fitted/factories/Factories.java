package programs.fitted.factories;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.navigation.DifferentialPilot;

/** Motors made by methods that are given the name of a port. */
@SuppressWarnings("deprecation")
public class Factories {
    public static void main(String[] args) {
        RegulatedMotor one = Parts.wheel(Parts.LEFT);
        RegulatedMotor other = Parts.wheel(Parts.RIGHT);
        RegulatedMotor arm = Parts.arm();
        DifferentialPilot pilot = new DifferentialPilot(DifferentialPilot.WHEEL_SIZE_EV3, 13.5, one, other);
        pilot.setLinearSpeed(15);
        pilot.setAngularSpeed(45);
        arm.rotate(45);
        pilot.travel(30);
        pilot.rotate(-90);
        pilot.travel(-30);
        float[] pressed = new float[1];
        Parts.touch().fetchSample(pressed, 0);
        System.out.println(pressed[0]);
    }
}
