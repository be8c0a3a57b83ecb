package brickless.world;

/** Sensors a robot file can name in {@code data-sensor}. */
public enum SensorType {
    EV3_TOUCH("ev3-touch"),
    EV3_COLOR("ev3-color"),
    EV3_ULTRASONIC("ev3-ultrasonic"),
    EV3_GYRO("ev3-gyro"),
    EV3_INFRARED("ev3-infrared"),
    NXT_TOUCH("nxt-touch"),
    NXT_LIGHT("nxt-light"),
    NXT_SOUND("nxt-sound"),
    NXT_COLOR("nxt-color"),
    NXT_ULTRASONIC("nxt-ultrasonic");

    private final String attribute;

    SensorType(String attribute) {
        this.attribute = attribute;
    }

    /** Value of {@code data-sensor}. */
    public String attribute() {
        return attribute;
    }
}
