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
    private boolean bumped;
    private int bumps;

    BackOff(Wheels wheels, EV3TouchSensor bumper) {
        this.wheels = wheels;
        this.bumper = new TouchAdapter(bumper);
    }

    @Override
    public boolean takeControl() {
        // A box that is pushed along lets the bumper go at once: remember the touch until it has been answered.
        bumped = bumped || bumper.isPressed();
        return bumped;
    }

    @Override
    public void action() {
        bumped = false;
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
