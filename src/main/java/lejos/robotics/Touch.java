package lejos.robotics;

/** A switch that something can press. */
public interface Touch {
    /** Whether it is pressed now. */
    boolean isPressed();
}
