package brickless.loading.hints;

import java.util.List;
import java.util.OptionalDouble;

/**
 * What a program's bytecode says about the robot it was written for.
 *
 * @param motors motors it opens, in order of ports
 * @param sensors sensors it opens, in order of ports
 * @param wheels wheels it declares through chassis or pilot constructors
 */
public record HardwareHints(List<Device> motors, List<Device> sensors, List<Wheel> wheels) {
    public HardwareHints {
        motors = List.copyOf(motors);
        sensors = List.copyOf(sensors);
        wheels = List.copyOf(wheels);
    }

    /**
     * A device at a port.
     *
     * @param port {@code A} to {@code D} or {@code S1} to {@code S4}
     * @param lejosClass simple name of the leJOS class that drives it
     * @param name field or variable the program keeps it in, empty if unknown
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
     * @param name field or variable of the motor, empty if unknown
     */
    public record Wheel(String port, double diameter, OptionalDouble offset, OptionalDouble trackWidth, double gearRatio, String name) {}
}
