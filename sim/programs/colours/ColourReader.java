package colours;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.robotics.Color;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;

/** Drives over four rows of six tiles, to and fro, and prints the colour of each. */
public class ColourReader {
    private static final double TILE_CM = 28;
    private static final double ROW_CM = 32;
    /** From the axle to the eye. */
    private static final double EYE_CM = 8.7;

    public static void main(String[] args) {
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
        EV3ColorSensor eye = new EV3ColorSensor(SensorPort.S3);
        Wheel leftWheel = WheeledChassis.modelWheel(left, 5.6).offset(6);
        Wheel rightWheel = WheeledChassis.modelWheel(right, 5.6).offset(-6);
        Chassis chassis = new WheeledChassis(new Wheel[] { leftWheel, rightWheel }, WheeledChassis.TYPE_DIFFERENTIAL);
        MovePilot pilot = new MovePilot(chassis);

        for (int row = 0; row < 4; row++) {
            System.out.println(name(eye.getColorID()));
            for (int tile = 1; tile < 6; tile++) {
                pilot.travel(TILE_CM);
                System.out.println(name(eye.getColorID()));
            }
            if (row < 3) {
                int turn = row % 2 == 0 ? -90 : 90;
                pilot.travel(2 * EYE_CM);
                pilot.rotate(turn);
                pilot.travel(ROW_CM);
                pilot.rotate(turn);
            }
        }
    }

    private static String name(int colour) {
        switch (colour) {
            case Color.BLACK:
                return "black";
            case Color.BLUE:
                return "blue";
            case Color.GREEN:
                return "green";
            case Color.YELLOW:
                return "yellow";
            case Color.RED:
                return "red";
            case Color.WHITE:
                return "white";
            case Color.BROWN:
                return "brown";
            default:
                return "nothing";
        }
    }
}
