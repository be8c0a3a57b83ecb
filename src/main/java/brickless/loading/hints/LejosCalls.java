package brickless.loading.hints;

import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import org.objectweb.asm.tree.MethodInsnNode;

/** The calls into leJOS that tell something about the robot. */
final class LejosCalls {
    private static final String MOTORS = "lejos/hardware/motor/";
    private static final String SENSORS = "lejos/hardware/sensor/";
    private static final Set<String> TWO_WHEEL_PILOTS = Set.of("lejos/robotics/navigation/DifferentialPilot",
            "lejos/robotics/navigation/MovePilot", "lejos/robotics/navigation/DifferentialMovePilot");

    private final Facts facts;

    LejosCalls(Facts facts) {
        this.facts = facts;
    }

    /** Value of a constant of the API: a port, or one of the ready-made motors; null for other fields. */
    static Clue constant(String owner, String name) {
        return switch (owner) {
            case "lejos/hardware/port/MotorPort", "lejos/hardware/port/SensorPort" -> name.matches("[A-D]|S[1-4]") ? Clue.port(name) : null;
            case "lejos/hardware/motor/Motor" -> name.matches("[A-D]") ? Clue.device("NXTRegulatedMotor", new java.util.TreeSet<>(Set.of(name))) : null;
            default -> null;
        };
    }

    /** What a constructor call makes, noting devices and wheels; null if nothing of interest. */
    Clue constructed(MethodInsnNode call, List<Clue> arguments) {
        if ((call.owner.startsWith(MOTORS) || call.owner.startsWith(SENSORS)) && arguments.size() > 1
                && arguments.get(1).kind() == Clue.Kind.PORT) {
            String type = call.owner.substring(call.owner.lastIndexOf('/') + 1);
            return opened(type, arguments.get(1).ports());
        }
        if (TWO_WHEEL_PILOTS.contains(call.owner)) {
            pilot(arguments);
        }
        return null;
    }

    private Clue opened(String type, SortedSet<String> ports) {
        ports.forEach(port -> facts.device(port, type));
        return Clue.device(type, ports);
    }

    private void pilot(List<Clue> arguments) {
        List<Clue> numbers = arguments.stream().filter(a -> a.kind() == Clue.Kind.NUMBER).toList();
        List<Clue> motors = arguments.stream().filter(a -> a.kind() == Clue.Kind.DEVICE && a.ports().size() == 1).toList();
        if (numbers.size() < 2 || motors.size() < 2) {
            return;
        }
        double track = numbers.size() > 2 ? numbers.get(2).number() : numbers.get(1).number();
        facts.wheel(motors.get(0).ports().first(), new Clue.Axle(numbers.get(0).number(), -track / 2, track, 1));
        facts.wheel(motors.get(1).ports().first(), new Clue.Axle(numbers.get(0).number(), track / 2, track, 1));
    }

    /** What a method call returns; null if nothing of interest. */
    Clue returned(MethodInsnNode call, List<Clue> arguments) {
        if (call.name.equals("getPort") && call.desc.startsWith("(Ljava/lang/String;)") && call.owner.startsWith("lejos/")) {
            Clue name = arguments.get(arguments.size() - 1);
            return name.kind() == Clue.Kind.TEXT && name.text().matches("[A-D]|S[1-4]") ? Clue.port(name.text()) : null;
        }
        if (call.name.equals("invertMotor") && arguments.get(0).kind() == Clue.Kind.DEVICE) {
            return arguments.get(0);
        }
        if (call.name.equals("modelWheel") && arguments.get(0).kind() == Clue.Kind.DEVICE) {
            return declared(arguments.get(0).ports(), new Clue.Axle(arguments.get(1).number(), Double.NaN, Double.NaN, 1));
        }
        if (call.owner.equals("lejos/robotics/chassis/WheeledChassis$Modeler") && arguments.get(0).kind() == Clue.Kind.WHEEL) {
            return modelled(call.name, arguments);
        }
        return call.name.equals("valueOf") || call.name.endsWith("Value") ? arguments.get(0).kind() == Clue.Kind.NUMBER ? arguments.get(0) : null : null;
    }

    private Clue modelled(String property, List<Clue> arguments) {
        Clue wheel = arguments.get(0);
        double value = arguments.size() > 1 ? arguments.get(1).number() : Double.NaN;
        Clue.Axle axle = wheel.wheel();
        return switch (property) {
            case "offset" -> declared(wheel.ports(), new Clue.Axle(axle.diameter(), value, axle.track(), axle.gear()));
            case "gearRatio" -> declared(wheel.ports(), new Clue.Axle(axle.diameter(), axle.offset(), axle.track(), value));
            default -> wheel;
        };
    }

    private Clue declared(SortedSet<String> ports, Clue.Axle axle) {
        if (!Double.isNaN(axle.diameter())) {
            ports.forEach(port -> facts.wheel(port, axle));
        }
        return Clue.wheel(ports, axle);
    }
}
