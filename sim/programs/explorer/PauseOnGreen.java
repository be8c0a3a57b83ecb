package explorer;

import lejos.hardware.Button;
import lejos.hardware.Sound;
import lejos.hardware.lcd.LCD;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.robotics.Color;
import lejos.robotics.subsumption.Behavior;
import lejos.utility.Delay;

/** Stops for a moment on a green patch and says so; then leaves it before looking for green again. */
class PauseOnGreen implements Behavior {
    private final Wheels wheels;
    private final EV3ColorSensor eye;
    private boolean wasGreen;
    private int visits;

    PauseOnGreen(Wheels wheels, EV3ColorSensor eye) {
        this.wheels = wheels;
        this.eye = eye;
    }

    @Override
    public boolean takeControl() {
        boolean green = eye.getColorID() == Color.GREEN;
        if (!green) {
            wasGreen = false;
        }
        return green && !wasGreen;
    }

    @Override
    public void action() {
        wheels.stop();
        wasGreen = true;
        visits++;
        LCD.drawString("Green " + visits, 0, 2);
        Button.LEDPattern(4);
        Sound.beepSequenceUp();
        Delay.msDelay(1000);
        Button.LEDPattern(1);
    }

    @Override
    public void suppress() {
        // The pause is short: let it end by itself.
    }
}
