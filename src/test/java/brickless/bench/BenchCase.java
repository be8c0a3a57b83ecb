package brickless.bench;

import brickless.simulation.KernelCost;
import java.util.List;
import java.util.Optional;
import programs.speed.Bumper;
import programs.speed.Courier;
import programs.speed.LinePoller;
import programs.speed.Yielders;

/**
 * One row of the table.
 *
 * @param name what it is called
 * @param group rows of one group give the same figures
 * @param conditions on the host
 * @param measurement what is measured
 * @param heap largest heap of the JVM
 */
record BenchCase(String name, String group, Conditions conditions, Measurement measurement, String heap) {
    private static final String SMALL_HEAP = "512m";
    private static final String LARGE_HEAP = "3g";

    /** All cases in the order in which they run. */
    static final List<BenchCase> ALL = List.of(
            program("bumper", Conditions.IDLE, Bumper.class, "pen"),
            program("line", Conditions.IDLE, LinePoller.class, "line-loop"),
            program("courier", Conditions.IDLE, Courier.class, "pen"),
            program("yielders", Conditions.IDLE, Yielders.class, "pen"),
            program("bumper-busy", Conditions.BUSY, Bumper.class, "pen"),
            program("line-busy", Conditions.BUSY, LinePoller.class, "line-loop"),
            program("courier-busy", Conditions.BUSY, Courier.class, "pen"),
            program("yielders-busy", Conditions.BUSY, Yielders.class, "pen"),
            program("bumper-one-core", Conditions.ONE_CORE, Bumper.class, "pen"),
            program("yielders-one-core", Conditions.ONE_CORE, Yielders.class, "pen"),
            robots(1), robots(10), robots(100), robots(1000),
            new BenchCase("bare-1", "steps", Conditions.IDLE, new BareSolver(1), SMALL_HEAP),
            new BenchCase("physics-1", "steps", Conditions.IDLE, new DrivingRobots(1), SMALL_HEAP),
            new BenchCase("bare-100", "steps", Conditions.IDLE, new BareSolver(100), SMALL_HEAP),
            new BenchCase("physics-100", "steps", Conditions.IDLE, new DrivingRobots(100), SMALL_HEAP),
            new BenchCase("kernel", "kernel", Conditions.IDLE, new KernelCost(), SMALL_HEAP),
            new BenchCase("compute", "compute", Conditions.IDLE, new ComputeCost(), SMALL_HEAP),
            new BenchCase("pieces", "pieces", Conditions.IDLE, new Pieces(), SMALL_HEAP),
            new BenchCase("cold", "cold", Conditions.IDLE, new ColdRun(), SMALL_HEAP));

    private static BenchCase program(String name, Conditions conditions, Class<?> program, String world) {
        return new BenchCase(name, "programs", conditions, new ProgramSpeed(program, world), SMALL_HEAP);
    }

    private static BenchCase robots(int number) {
        return new BenchCase("robots-" + number, "robots", Conditions.IDLE, new ManyRobots(number), LARGE_HEAP);
    }

    /**
     * The case with a name.
     *
     * @throws IllegalArgumentException if there is none; the message lists all
     */
    static BenchCase named(String name) {
        return ALL.stream().filter(c -> c.name.equals(name)).findFirst().orElseThrow(() -> new IllegalArgumentException(
                "no case " + name + "; cases are " + String.join(", ", ALL.stream().map(BenchCase::name).toList())));
    }

    /** The case that this one is compared with: bare JBox2D. */
    Optional<String> yardstick() {
        return name.startsWith("physics-") ? Optional.of(name.replace("physics", "bare")) : Optional.empty();
    }
}
