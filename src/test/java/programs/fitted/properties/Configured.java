package programs.fitted.properties;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;
import lejos.utility.PilotProps;

/** The way of the leJOS samples: sizes and ports come from a properties file, or are these. */
public class Configured {
    public static void main(String[] args) throws Exception {
        PilotProps props = new PilotProps();
        props.loadPersistentValues();
        float wheelDiameter = Float.parseFloat(props.getProperty(PilotProps.KEY_WHEELDIAMETER, "4.96"));
        float trackWidth = Float.parseFloat(props.getProperty(PilotProps.KEY_TRACKWIDTH, "13.0"));
        RegulatedMotor left = PilotProps.getMotor(props.getProperty(PilotProps.KEY_LEFTMOTOR, "B"));
        RegulatedMotor right = PilotProps.getMotor(props.getProperty(PilotProps.KEY_RIGHTMOTOR, "A"));
        boolean reverse = Boolean.parseBoolean(props.getProperty(PilotProps.KEY_REVERSE, "false"));

        Wheel wheel1 = WheeledChassis.modelWheel(left, wheelDiameter).offset(-trackWidth / 2).invert(reverse);
        Wheel wheel2 = WheeledChassis.modelWheel(right, wheelDiameter).offset(trackWidth / 2).invert(reverse);
        Chassis chassis = new WheeledChassis(new Wheel[] {wheel1, wheel2}, WheeledChassis.TYPE_DIFFERENTIAL);
        MovePilot robot = new MovePilot(chassis);
        robot.setLinearSpeed(15);
        robot.setAngularSpeed(45);
        for (int i = 0; i < 2; i++) {
            robot.travel(40);
            robot.rotate(90);
        }
    }
}
