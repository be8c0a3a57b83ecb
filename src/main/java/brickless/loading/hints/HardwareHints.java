package brickless.loading.hints;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;

/**
 * What a program's bytecode says about the robot it was written for.
 *
 * @param motors motors it opens, in order of ports
 * @param sensors sensors it opens, in order of ports
 * @param wheels ordinary wheels it declares through chassis or pilot constructors
 * @param omniWheels wheels of a holonomic chassis or pilot
 * @param reversed ports of motors that the program takes to be mounted the other way round
 * @param numbers positive numbers by the names of the fields and variables that hold them, in the order found: programs
 *     without a pilot keep the sizes of their wheels there
 */
public record HardwareHints(List<Device> motors, List<Device> sensors, List<Wheel> wheels, List<OmniWheel> omniWheels,
        Set<String> reversed, Map<String, Double> numbers) {
    public HardwareHints {
        motors = List.copyOf(motors);
        sensors = List.copyOf(sensors);
        wheels = List.copyOf(wheels);
        omniWheels = List.copyOf(omniWheels);
        reversed = Collections.unmodifiableSet(new TreeSet<>(reversed));
        numbers = Collections.unmodifiableMap(new LinkedHashMap<>(numbers));
    }

    /** Hints of a program that declares no omni wheels and no reversed motors. */
    public HardwareHints(List<Device> motors, List<Device> sensors, List<Wheel> wheels) {
        this(motors, sensors, wheels, List.of(), Set.of(), Map.of());
    }

    /**
     * A device at a port.
     *
     * @param port {@code A} to {@code D} or {@code S1} to {@code S4}
     * @param lejosClass simple name of the leJOS class that drives it
     * @param name fields and variables the program keeps it in, separated by spaces, empty if unknown
     */
    public record Device(String port, String lejosClass, String name) {}

    /**
     * A wheel as the program describes it, in the program's own unit of length.
     *
     * @param port port of its motor
     * @param diameter tyre diameter
     * @param offset distance from the middle of the axle with the program's sign; empty if the program does not say
     * @param trackWidth distance between the wheels of a two-wheel pilot; empty if the program gives offsets instead
     * @param gearRatio motor turns per wheel turn
     * @param name fields and variables of the motor, separated by spaces, empty if unknown
     */
    public record Wheel(String port, double diameter, OptionalDouble offset, OptionalDouble trackWidth,
            double gearRatio, String name) {}

    /**
     * An omni wheel as the program describes it, in the program's own unit of length.
     *
     * @param port port of its motor
     * @param diameter wheel diameter
     * @param x distance ahead of the middle
     * @param y distance to the left of the middle
     * @param headingDegrees driving direction, counter-clockwise from ahead
     * @param gearRatio motor turns per wheel turn
     */
    public record OmniWheel(String port, double diameter, double x, double y, double headingDegrees,
            double gearRatio) {}
}
