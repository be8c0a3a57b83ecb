package lejos.robotics;

/** A sensor that measures colours. */
public interface ColorDetector extends ColorIdentifier {
    /** The colour seen, as red, green and blue. */
    Color getColor();
}
