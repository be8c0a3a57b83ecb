package brickless.loading.hints;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.MethodInsnNode;

/** The calls into leJOS that tell something about the robot. */
final class LejosCalls {
    private static final String MOTORS = "lejos/hardware/motor/";
    private static final String SENSORS = "lejos/hardware/sensor/";
    private static final String FILTERS = "lejos/robotics/filter/";
    private static final String MODELER = "lejos/robotics/chassis/WheeledChassis$Modeler";
    private static final String HOLONOMIC_MODELER = "lejos/robotics/chassis/WheeledChassis$HolonomicModeler";
    private static final Set<String> TWO_WHEEL_PILOTS = Set.of("lejos/robotics/navigation/DifferentialPilot",
            "lejos/robotics/navigation/MovePilot", "lejos/robotics/navigation/CompassPilot");
    /** What leJOS makes of a motor that the program only names. */
    private static final String READY_MADE = "NXTRegulatedMotor";
    private static final String OMNI_PILOT = "lejos/robotics/navigation/OmniPilot";

    private final Facts facts;

    LejosCalls(Facts facts) {
        this.facts = facts;
    }

    /** Value of a constant of the API: a port, or one of the ready-made motors; null for other fields. */
    static Clue constant(String owner, String name) {
        return switch (owner) {
            case "lejos/hardware/port/MotorPort", "lejos/hardware/port/SensorPort" -> Clue.isPort(name)
                    ? Clue.port(name) : null;
            case "lejos/hardware/motor/Motor" -> Clue.isPort(name)
                    ? Clue.device(READY_MADE, new TreeSet<>(Set.of(name))) : null;
            default -> null;
        };
    }

    /** What a constructor call makes, noting devices and wheels; null if nothing of interest. */
    Clue constructed(MethodInsnNode call, List<Clue> arguments) {
        Clue first = arguments.size() > 1 ? arguments.get(1) : Clue.unknown(1);
        if ((call.owner.startsWith(MOTORS) || call.owner.startsWith(SENSORS)) && first.is(Clue.Kind.PORT)) {
            String type = call.owner.substring(call.owner.lastIndexOf('/') + 1);
            first.ports().forEach(port -> facts.device(port, type));
            return Clue.device(type, first.ports());
        }
        if (call.owner.equals(MODELER) || call.owner.equals(HOLONOMIC_MODELER)) {
            return wheel(first, call.owner.equals(MODELER) ? Axle.ordinary(arguments.get(2).number())
                    : Axle.omni(arguments.get(2).number()));
        }
        if (TWO_WHEEL_PILOTS.contains(call.owner)) {
            pilot(call, arguments);
        } else if (call.owner.equals(OMNI_PILOT)) {
            omniPilot(arguments);
        }
        return call.owner.startsWith(FILTERS) && first.is(Clue.Kind.DEVICE) ? first : null;
    }

    /**
     * Constructors of two-wheel pilots: one or two diameters, the track, left and right motor, and perhaps whether both
     * are reversed.
     */
    private void pilot(MethodInsnNode call, List<Clue> arguments) {
        List<Double> lengths = new ArrayList<>();
        List<Clue> motors = new ArrayList<>();
        boolean reverse = false;
        Type[] types = Type.getArgumentTypes(call.desc);
        for (int i = 0; i < types.length; i++) {
            Clue argument = arguments.get(i + 1);
            if (types[i].getSort() == Type.DOUBLE || types[i].getSort() == Type.FLOAT) {
                lengths.add(argument.number());
            } else if (types[i].getSort() == Type.BOOLEAN) {
                reverse = argument.number() == 1;
            } else if (argument.is(Clue.Kind.DEVICE) && argument.ports().size() == 1) {
                motors.add(argument);
            }
        }
        if (lengths.size() >= 2 && motors.size() == 2) {
            double track = lengths.get(lengths.size() - 1);
            for (int side = 0; side < 2; side++) {
                facts.wheel(motors.get(side).ports(), Axle.ordinary(lengths.get(Math.min(side, lengths.size() - 2)))
                        .atOffset((side - 0.5) * track).withTrack(track));
                if (reverse) {
                    facts.reversed(motors.get(side).ports());
                }
            }
        }
    }

    /**
     * Distance from the middle, diameter, the central motor, those 120 degrees clockwise and counter-clockwise, central
     * in front, reversed.
     */
    private void omniPilot(List<Clue> arguments) {
        boolean behind = arguments.get(6).number() == 0;
        double[] angles = {0, -120, 120};
        for (int i = 0; i < angles.length; i++) {
            Clue motor = arguments.get(3 + i);
            double angle = angles[i] + (behind ? 180 : 0);
            Axle wheel = Axle.omni(arguments.get(2).number()).polar(angle, arguments.get(1).number());
            facts.wheel(motor.ports(), wheel.cartesian(wheel.place().x(), wheel.place().y(), angle - 90));
            if (arguments.get(7).number() == 1) {
                facts.reversed(motor.ports());
            }
        }
    }

    /** What a method call returns; null if nothing of interest. */
    Clue returned(MethodInsnNode call, List<Clue> arguments) {
        Clue first = arguments.isEmpty() ? Clue.unknown(1) : arguments.get(0);
        if (call.name.equals("getPort") && call.desc.startsWith("(Ljava/lang/String;)")
                && call.owner.startsWith("lejos/")) {
            Clue name = arguments.get(arguments.size() - 1);
            return name.is(Clue.Kind.TEXT) && !name.ports().isEmpty() ? Clue.port(name.ports()) : null;
        }
        if (call.owner.equals("lejos/utility/PilotProps") && call.name.equals("getMotor") && !first.ports().isEmpty()) {
            first.ports().forEach(port -> facts.device(port, READY_MADE));
            return Clue.device(READY_MADE, first.ports());
        }
        if (call.owner.equals("lejos/robotics/MirrorMotor") && first.is(Clue.Kind.DEVICE)) {
            facts.reversed(first.ports());
            return first;
        }
        if (call.name.equals("modelWheel") || call.name.equals("modelHolonomicWheel")) {
            double diameter = arguments.size() == 2 ? arguments.get(1).number() : Double.NaN;
            return wheel(first, call.name.equals("modelWheel") ? Axle.ordinary(diameter) : Axle.omni(diameter));
        }
        if (first.is(Clue.Kind.WHEEL) && (call.owner.equals(MODELER) || call.owner.equals(HOLONOMIC_MODELER))) {
            return modelled(call.name, arguments);
        }
        return first.is(Clue.Kind.DEVICE) && isMode(call) ? first : null;
    }

    /** Modes of a sensor are known by the names of their variables as much as the sensor itself. */
    private static boolean isMode(MethodInsnNode call) {
        return call.name.startsWith("get") && (call.desc.endsWith(")Llejos/robotics/SampleProvider;")
                || call.desc.endsWith(")Llejos/hardware/sensor/SensorMode;"));
    }

    private Clue modelled(String property, List<Clue> arguments) {
        SortedSet<String> ports = arguments.get(0).ports();
        Axle axle = arguments.get(0).axle();
        double[] numbers = arguments.stream().skip(1).mapToDouble(Clue::number).toArray();
        if (property.equals("invert") && numbers[0] == 1) {
            facts.reversed(ports);
        }
        return wheel(arguments.get(0), switch (property) {
            case "offset" -> axle.atOffset(numbers[0]);
            case "gearRatio" -> axle.geared(numbers[0]);
            case "polarPosition" -> axle.polar(numbers[0], numbers[1]);
            case "cartesianPosition" -> axle.cartesian(numbers[0], numbers[1], numbers[2]);
            default -> axle;
        });
    }

    private Clue wheel(Clue motorOrWheel, Axle axle) {
        if (!motorOrWheel.is(Clue.Kind.DEVICE) && !motorOrWheel.is(Clue.Kind.WHEEL)) {
            return null;
        }
        facts.wheel(motorOrWheel.ports(), axle);
        return Clue.wheel(motorOrWheel.ports(), axle);
    }
}
