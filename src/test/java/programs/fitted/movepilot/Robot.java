package programs.fitted.movepilot;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;

class Robot {
    private static final double DIAMETER = 4.32;
    private static final double OFFSET = 8.0;

    final MovePilot pilot;

    Robot(RegulatedMotor motorLinks, RegulatedMotor motorRechts) {
        Wheel links = WheeledChassis.modelWheel(motorLinks, DIAMETER).offset(-OFFSET);
        Wheel rechts = WheeledChassis.modelWheel(motorRechts, DIAMETER).offset(OFFSET);
        Chassis chassis = new WheeledChassis(new Wheel[] {links, rechts}, WheeledChassis.TYPE_DIFFERENTIAL);
        pilot = new MovePilot(chassis);
    }
}
