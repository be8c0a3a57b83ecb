package explorer;

import lejos.hardware.Button;
import lejos.hardware.Sound;
import lejos.hardware.lcd.LCD;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.robotics.Color;
import lejos.robotics.subsumption.Behavior;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** Stops for a moment on a green patch and says so; then takes no notice of green for a while, so as to get away from it. */
class PauseOnGreen implements Behavior {
    private static final int REST_MILLIS = 15000;
    private final Wheels wheels;
    private final EV3ColorSensor eye;
    private final Stopwatch sinceLast = new Stopwatch();
    private int visits;

    PauseOnGreen(Wheels wheels, EV3ColorSensor eye) {
        this.wheels = wheels;
        this.eye = eye;
    }

    @Override
    public boolean takeControl() {
        boolean rested = visits == 0 || sinceLast.elapsed() > REST_MILLIS;
        return rested && eye.getColorID() == Color.GREEN;
    }

    @Override
    public void action() {
        wheels.stop();
        visits++;
        sinceLast.reset();
        LCD.drawString("Green " + visits, 0, 5);
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
