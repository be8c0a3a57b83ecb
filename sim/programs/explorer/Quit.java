package explorer;

import lejos.hardware.Button;
import lejos.robotics.subsumption.Behavior;

/** Ends the program when ESCAPE is pressed. */
class Quit implements Behavior {
    private final Wheels wheels;

    Quit(Wheels wheels) {
        this.wheels = wheels;
    }

    @Override
    public boolean takeControl() {
        return Button.ESCAPE.isDown();
    }

    @Override
    public void action() {
        wheels.stop();
        Button.LEDPattern(0);
        System.exit(0);
    }

    @Override
    public void suppress() {
        // Nothing outranks quitting.
    }
}
