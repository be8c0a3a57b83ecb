package lejos.robotics;

/** A sensor that names colours. */
public interface ColorIdentifier {
    /** The colour seen, one of the constants of {@link Color}; {@link Color#NONE} if there is none. */
    int getColorID();
}
