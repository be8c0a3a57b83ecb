package brickless.world.svg;

import brickless.units.Angles;
import brickless.world.DescriptionException;
import brickless.world.MotorType;
import brickless.world.SensorType;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Reads the attributes that robot parts share and sees that no port is used twice. One per robot. */
final class RobotPart {
    static final List<String> KINDS = List.of("chassis", "wheel", "caster", "sensor", "turret", "claw", "arm");
    private static final String[] MOTOR_PORTS = {"A", "B", "C", "D"};
    private static final String[] SENSOR_PORTS = {"S1", "S2", "S3", "S4"};

    private final SvgDocument document;
    private final Map<String, SvgElement> ports = new HashMap<>();

    RobotPart(SvgDocument document) {
        this.document = document;
    }

    int motorPort(SvgElement element) throws DescriptionException {
        return port(element, "a motor", MOTOR_PORTS);
    }

    int sensorPort(SvgElement element) throws DescriptionException {
        return port(element, "a sensor", SENSOR_PORTS);
    }

    static MotorType motor(Meaning meaning, MotorType fallback) throws DescriptionException {
        String[] allowed = Arrays.stream(MotorType.values()).map(MotorType::attribute).toArray(String[]::new);
        String value = meaning.choice("data-motor", fallback.attribute(), allowed);
        return Arrays.stream(MotorType.values()).filter(type -> type.attribute().equals(value)).findFirst()
                .orElseThrow();
    }

    /** Play of a gear train in radians; none unless the drawing says so. */
    static double backlash(Meaning meaning) throws DescriptionException {
        return Angles.radiansFromDegrees(meaning.number("data-backlash-degrees", 0, 0, 90));
    }

    SensorType sensor(SvgElement element, Meaning meaning) throws DescriptionException {
        String[] allowed = Arrays.stream(SensorType.values()).map(SensorType::attribute).toArray(String[]::new);
        if (!meaning.has("data-sensor")) {
            throw document.error(element, "a sensor needs data-sensor; allowed: " + String.join(", ", allowed));
        }
        String value = meaning.choice("data-sensor", "", allowed);
        return Arrays.stream(SensorType.values()).filter(type -> type.attribute().equals(value)).findFirst()
                .orElseThrow();
    }

    /** A port is never inherited: a sensor on a turret does not sit on the turret's motor port. */
    private int port(SvgElement element, String kind, String... allowed) throws DescriptionException {
        String port = element.attributes().getOrDefault("data-port", "");
        int index = Arrays.asList(allowed).indexOf(port);
        if (index < 0) {
            throw document.error(element, (port.isEmpty() ? kind + " needs data-port" : "data-port=\""
                    + LengthParser.shortened(port) + "\" is not a port for "
                    + kind) + "; allowed: " + String.join(", ", allowed));
        }
        SvgElement other = ports.putIfAbsent(port, element);
        if (other != null) {
            throw document.error(element, "port " + port + " is taken already by " + other.title() + " in line "
                    + other.line()
                    + "; each motor and sensor needs a port of its own");
        }
        return index;
    }
}
