package brickless.physics;

/** The outline of a touch sensor: pressed when something pushes it, until it is free again. */
public final class Bumper {
    /** Force that moves the button: assumption, a light push. */
    static final double PRESS_NEWTONS = 0.3;

    private int touching;
    private double impulse;
    private boolean pressed;

    /** Whether something presses the sensor. */
    public boolean pressed() {
        return pressed;
    }

    void begin() {
        touching++;
    }

    void end() {
        touching--;
    }

    void push(double newtonSeconds) {
        impulse += newtonSeconds;
    }

    void finish(double dt) {
        pressed = touching > 0 && (pressed || impulse >= PRESS_NEWTONS * dt);
        impulse = 0;
    }
}
