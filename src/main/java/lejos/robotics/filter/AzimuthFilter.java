package lejos.robotics.filter;

/** Holds its name in the API; leJOS 0.9.1 gives it no members. */
public class AzimuthFilter {
    /** An object without members. */
    public AzimuthFilter() {
    }
}
