package detectors;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.robotics.TouchAdapter;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.objectdetection.Feature;
import lejos.robotics.objectdetection.FeatureDetector;
import lejos.robotics.objectdetection.FeatureListener;
import lejos.robotics.objectdetection.TouchFeatureDetector;

/** Drives ahead until it touches something, and backs off by 20 cm. */
public class TouchStop {
    public static void main(String[] args) throws InterruptedException {
        final MovePilot pilot = new MovePilot(new WheeledChassis(new Wheel[] { WheeledChassis.modelWheel(Motor.B, 5.6).offset(6),
                WheeledChassis.modelWheel(Motor.C, 5.6).offset(-6) }, WheeledChassis.TYPE_DIFFERENTIAL));
        pilot.setLinearSpeed(15);
        FeatureDetector detector = new TouchFeatureDetector(new TouchAdapter(new EV3TouchSensor(SensorPort.S1)));
        detector.addListener(new FeatureListener() {
            public void featureDetected(Feature feature, FeatureDetector source) {
                source.enableDetection(false);
                pilot.stop();
                System.out.println("touched");
            }
        });
        pilot.travel(500);
        pilot.travel(-20);
        System.out.println("backed off");
    }
}
