package explorer;

import lejos.hardware.lcd.LCD;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.robotics.TouchAdapter;
import lejos.robotics.subsumption.Behavior;
import lejos.utility.Delay;

/** When the bumper hits something: push on for half a second, it may be a box, then back off and turn. */
class BackOff implements Behavior {
    private final Wheels wheels;
    private final TouchAdapter bumper;
    private int bumps;

    BackOff(Wheels wheels, EV3TouchSensor bumper) {
        this.wheels = wheels;
        this.bumper = new TouchAdapter(bumper);
    }

    @Override
    public boolean takeControl() {
        return bumper.isPressed();
    }

    @Override
    public void action() {
        bumps++;
        LCD.drawString("Bumps " + bumps, 0, 6);
        wheels.forward(240);
        Delay.msDelay(500);
        wheels.backward(300);
        Delay.msDelay(900);
        wheels.spin(bumps % 2 == 0 ? 200 : -150);
        while (wheels.moving()) {
            Thread.yield();
        }
        wheels.stop();
    }

    @Override
    public void suppress() {
        // Backing off is short and must not be left half done.
    }
}
