package kit;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3GyroSensor;
import lejos.robotics.DirectionFinderAdapter;
import lejos.robotics.navigation.CompassPilot;

/** A square whose directions a compass keeps, which is a gyro here; centimetres. */
public final class CompassSquare {
    private CompassSquare() {}

    @SuppressWarnings("deprecation")
    public static void main(String[] args) {
        DirectionFinderAdapter compass = new DirectionFinderAdapter(new EV3GyroSensor(SensorPort.S2).getAngleMode());
        CompassPilot pilot = new CompassPilot(compass, 5.6f, 12f, Motor.B, Motor.C);
        pilot.setLinearSpeed(15);
        pilot.setAngularSpeed(60);
        for (int side = 0; side < 4; side++) {
            pilot.travel(30f);
            pilot.rotate(90f);
        }
        System.out.println("compass " + pilot.getCompassHeading());
        System.exit(0);
    }
}
