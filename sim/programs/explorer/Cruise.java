package explorer;

import lejos.robotics.subsumption.Behavior;

/** Drives straight on when nothing else wants to. */
class Cruise implements Behavior {
    private final Wheels wheels;
    private volatile boolean suppressed;

    Cruise(Wheels wheels) {
        this.wheels = wheels;
    }

    @Override
    public boolean takeControl() {
        return true;
    }

    @Override
    public void action() {
        suppressed = false;
        wheels.forward(360);
        while (!suppressed) {
            Thread.yield();
        }
        wheels.stop();
    }

    @Override
    public void suppress() {
        suppressed = true;
    }
}
