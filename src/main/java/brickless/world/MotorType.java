package brickless.world;

/** Motors a robot file can name in {@code data-motor}. */
public enum MotorType {
    /** The EV3's large servo motor. */
    LARGE("ev3-large", "large"),
    /** The EV3's medium servo motor. */
    MEDIUM("ev3-medium", "medium"),
    /** The NXT's servo motor. */
    NXT("nxt", "nxt");

    private final String title;
    private final String attribute;

    MotorType(String title, String attribute) {
        this.title = title;
        this.attribute = attribute;
    }

    /** Name for messages. */
    public String title() {
        return title;
    }

    /** Value of {@code data-motor}. */
    public String attribute() {
        return attribute;
    }
}
