package brickless.world;

/** Sensors a robot file can name in {@code data-sensor}. */
public enum SensorType {
    /** EV3 touch sensor, a switch. */
    EV3_TOUCH("ev3-touch"),
    /** EV3 colour sensor. */
    EV3_COLOR("ev3-color"),
    /** EV3 ultrasonic distance sensor. */
    EV3_ULTRASONIC("ev3-ultrasonic"),
    /** EV3 gyro sensor. */
    EV3_GYRO("ev3-gyro"),
    /** EV3 infrared sensor: distance, beacon and remote control. */
    EV3_INFRARED("ev3-infrared"),
    /** NXT touch sensor, a switch. */
    NXT_TOUCH("nxt-touch"),
    /** NXT light sensor with a red lamp. */
    NXT_LIGHT("nxt-light"),
    /** NXT sound sensor. */
    NXT_SOUND("nxt-sound"),
    /** NXT colour sensor. */
    NXT_COLOR("nxt-color"),
    /** NXT ultrasonic distance sensor on I²C. */
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
