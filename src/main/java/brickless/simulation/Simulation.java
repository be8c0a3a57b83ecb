package brickless.simulation;

import brickless.program.Program;

/**
 * A world, a robot and a seed, ready to run programs.
 *
 * <pre>
 * Simulation simulation = new Simulation(SimulationSettings.builder(world).robot(robot).build());
 * Run run = simulation.start(BumperCar.class);
 * run.advance(Duration.ofSeconds(30));
 * </pre>
 */
public final class Simulation {
    private final SimulationSettings settings;

    /** Creates a simulation. */
    public Simulation(SimulationSettings settings) {
        this.settings = settings;
    }

    /** The settings. */
    public SimulationSettings settings() {
        return settings;
    }

    /** Starts the main method of a class of this JVM's class path; it stands still before its first instruction. */
    public Run start(Class<?> mainClass) {
        return start(Program.onClassPath(mainClass.getName()));
    }

    /**
     * Starts a program; it stands still before its first instruction.
     *
     * @throws SetupException if program, world and robot do not fit together
     */
    public Run start(Program program) {
        return new Run(new RunEngine(settings, program));
    }
}
