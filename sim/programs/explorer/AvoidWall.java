package explorer;

import lejos.hardware.lcd.LCD;
import lejos.robotics.SampleProvider;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.subsumption.Behavior;

/** Turns away from walls before they are reached, alternately further to either side. */
class AvoidWall implements Behavior {
    private static final float NEAR = 0.22f;
    private final Wheels wheels;
    private final SampleProvider distance;
    private final float[] sample = new float[1];
    private volatile boolean suppressed;
    private int turns;

    AvoidWall(Wheels wheels, EV3UltrasonicSensor ear) {
        this.wheels = wheels;
        this.distance = ear.getDistanceMode();
    }

    @Override
    public boolean takeControl() {
        distance.fetchSample(sample, 0);
        return sample[0] < NEAR;
    }

    @Override
    public void action() {
        suppressed = false;
        turns++;
        LCD.drawString("Walls " + turns, 0, 4);
        wheels.spin(turns % 3 == 0 ? -170 : 140);
        while (!suppressed && wheels.moving()) {
            Thread.yield();
        }
        wheels.stop();
    }

    @Override
    public void suppress() {
        suppressed = true;
    }
}
