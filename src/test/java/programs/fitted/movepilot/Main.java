package programs.fitted.movepilot;

import lejos.hardware.BrickFinder;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;
import lejos.robotics.navigation.MovePilot;

/** A pilot in centimetres, made by a class for the robot. */
public class Main {
    public static void main(String[] args) {
        Robot robot = new Robot(new EV3LargeRegulatedMotor(MotorPort.D), new EV3LargeRegulatedMotor(MotorPort.A));
        SampleProvider distance = new EV3UltrasonicSensor(BrickFinder.getDefault().getPort("S2")).getDistanceMode();
        float[] sample = new float[distance.sampleSize()];
        MovePilot pilot = robot.pilot;
        pilot.setLinearSpeed(20);
        pilot.setAngularSpeed(90);
        pilot.travel(50);
        pilot.rotate(-90);
        pilot.travelArc(30, 47.124);
        distance.fetchSample(sample, 0);
        System.out.println(sample[0]);
    }
}
