package detectors;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.RangeFinderAdapter;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.objectdetection.Feature;
import lejos.robotics.objectdetection.FeatureDetector;
import lejos.robotics.objectdetection.FeatureListener;
import lejos.robotics.objectdetection.RangeFeatureDetector;

/** Drives ahead until a range detector sees something nearer than 40 cm. */
public class RangeStop {
    /** Ranges of the detector are in metres, as the sensor gives them. */
    private static final float NEAR_METRES = 0.40f;

    public static void main(String[] args) throws InterruptedException {
        final MovePilot pilot = new MovePilot(new WheeledChassis(new Wheel[] { WheeledChassis.modelWheel(Motor.B, 5.6).offset(6),
                WheeledChassis.modelWheel(Motor.C, 5.6).offset(-6) }, WheeledChassis.TYPE_DIFFERENTIAL));
        pilot.setLinearSpeed(30);
        EV3UltrasonicSensor sonar = new EV3UltrasonicSensor(SensorPort.S4);
        FeatureDetector detector = new RangeFeatureDetector(new RangeFinderAdapter(sonar.getDistanceMode()), NEAR_METRES, 50);
        detector.addListener(new FeatureListener() {
            public void featureDetected(Feature feature, FeatureDetector source) {
                source.enableDetection(false);
                pilot.stop();
                System.out.println("seen at " + feature.getRangeReading().getRange());
            }
        });
        pilot.forward();
        while (pilot.isMoving()) {
            Thread.sleep(20);
        }
    }
}
