package explorer;

import lejos.hardware.Button;
import lejos.hardware.lcd.LCD;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

/**
 * Explores a pen: cruises, turns away from walls it hears, pushes what it bumps into a little and backs off, pauses on a
 * green patch, and ends when ESCAPE is pressed.
 */
public class Explorer {
    public static void main(String[] args) {
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
        EV3TouchSensor bumper = new EV3TouchSensor(SensorPort.S1);
        EV3ColorSensor eye = new EV3ColorSensor(SensorPort.S3);
        EV3UltrasonicSensor ear = new EV3UltrasonicSensor(SensorPort.S4);
        Wheels wheels = new Wheels(left, right);

        LCD.drawString("Explorer", 0, 3); // what is printed scrolls through the rows above
        Button.LEDPattern(1);

        Behavior[] behaviors = {
            new Cruise(wheels),
            new AvoidWall(wheels, ear),
            new PauseOnGreen(wheels, eye),
            new BackOff(wheels, bumper),
            new Quit(wheels)
        };
        Arbitrator arbitrator = new Arbitrator(behaviors);
        arbitrator.go();
    }
}
