package brickless.simulation.kit;

/** What surrounds the sensors, with known distances, and the robots that carry them. */
final class Worlds {
    /** A wall whose near face is 500 mm ahead of sensors mounted at 60 mm. */
    static final String WALL = "<rect id='wall' data-solid='fixed' x='1560' y='500' width='20' height='1000' "
            + "fill='#808080'/>";
    /**
     * Everything there is to sense: the wall, a beacon ahead to the right in front of it, red paint under the colour
     * sensor.
     */
    static final String ROOM = Kit.world("<rect x='1020' y='980' width='40' height='40' fill='red'/>" + WALL
            + "<circle id='beacon' data-beacon='1' cx='1360' cy='1000' r='5'/>");
    /** Touch on S1, gyro on S2, colour on S3, ultrasonic on S4. */
    static final String EV3 = Kit.robot(
            sensor("S1", "ev3-touch", 60, 20, 30) + sensor("S2", "ev3-gyro", 10, 0, 60) + colour("S3", "ev3-color")
            + sensor("S4", "ev3-ultrasonic", 50, 0, 60));
    /** Infrared on S1, NXT light on S2, NXT colour on S3, NXT ultrasonic on S4. */
    static final String OLDER = Kit.robot(sensor("S1", "ev3-infrared", 50, 0, 60) + colour("S2", "nxt-light")
            + colour("S3", "nxt-color")
            + sensor("S4", "nxt-ultrasonic", 50, 0, 60));

    private Worlds() {}

    /** A box of 10 mm whose front is 10 mm ahead of {@code x}. */
    static String sensor(String port, String type, int x, int y, int height) {
        return "<rect data-part='sensor' id='" + type + "' data-port='" + port + "' data-sensor='" + type + "' x='"
                + x + "' y='" + (y - 5)
                + "' width='10' height='10' data-height-mm='" + height + "'/>";
    }

    /** A sensor that looks down on the floor 40 mm ahead of the axle. */
    static String colour(String port, String type) {
        return sensor(port, type, 35, 0, 8);
    }
}
