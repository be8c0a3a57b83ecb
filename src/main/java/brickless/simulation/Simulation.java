package brickless.simulation;

import brickless.program.Program;
import brickless.trace.TraceListener;
import java.lang.reflect.Modifier;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/**
 * A world, a robot and a seed, ready to run programs.
 *
 * <pre>
 * Simulation simulation = new Simulation(SimulationSettings.builder(world).robot(robot).build());
 * Run run = simulation.start(BumperCar.class);
 * run.advance(Duration.ofSeconds(30));
 * </pre>
 *
 * <p>If several runs are started, the files of the second go into the folder with {@code -2} behind its name, and so
 * on. Thread-safe.
 */
public final class Simulation {
    private final SimulationSettings settings;
    private final Consumer<Run> started;
    private final AtomicInteger runs = new AtomicInteger();

    /** Creates a simulation. */
    public Simulation(SimulationSettings settings) {
        this(settings, run -> { });
    }

    /**
     * Creates a simulation that tells about its runs.
     *
     * @param started is given every run that is started, so that it can be closed
     */
    public Simulation(SimulationSettings settings, Consumer<Run> started) {
        this.settings = settings;
        this.started = started;
    }

    /** The settings. */
    public SimulationSettings settings() {
        return settings;
    }

    /** The same with another seed; the files of its runs go into a folder of their own. */
    public Simulation withSeed(long seed) {
        Optional<Path> out = settings.out().map(folder -> folder.resolveSibling(folder.getFileName() + "-seed" + seed));
        return new Simulation(settings.toBuilder().seed(seed).out(out).build(), started);
    }

    /**
     * Starts the main method of a class of this JVM's class path; it stands still before its first instruction.
     *
     * @throws SetupException if it has none, or program, world and robot do not fit together
     */
    public Run start(Class<?> mainClass) {
        if (!hasMain(mainClass)) {
            throw new SetupException(mainClass.getName() + ": has no method public static void main(String[])");
        }
        return start(Program.onClassPath(mainClass.getName()));
    }

    private static boolean hasMain(Class<?> type) {
        try {
            return Modifier.isStatic(type.getMethod("main", String[].class).getModifiers());
        } catch (NoSuchMethodException e) {
            return false;
        }
    }

    /**
     * Starts a program; it stands still before its first instruction.
     *
     * @throws SetupException if program, world and robot do not fit together
     */
    public Run start(Program program) {
        return start(program, Optional.empty(), TraceListener.NONE);
    }

    /**
     * Starts a program and tells somebody what the trace tells; it stands still before its first instruction.
     *
     * @param listener called by the thread of this call, then by the run while it goes on
     * @throws SetupException if program, world and robot do not fit together
     */
    public Run start(Program program, TraceListener listener) {
        return start(program, Optional.empty(), listener);
    }

    /**
     * Starts something that is no main method; it stands still before its first instruction.
     *
     * @param program class that tells which ports and devices are used
     * @param body what to run
     * @throws SetupException if program, world and robot do not fit together
     */
    public Run start(Class<?> program, ProgramBody body) {
        return start(Program.onClassPath(program.getName()), Optional.of(body), TraceListener.NONE);
    }

    private Run start(Program program, Optional<ProgramBody> body, TraceListener listener) {
        int number = runs.incrementAndGet();
        Optional<Path> out = settings.out().map(folder -> number == 1 ? folder
                : folder.resolveSibling(folder.getFileName() + "-" + number));
        Run run = new Run(new RunEngine(settings.toBuilder().out(out).build(), program, body, listener));
        started.accept(run);
        return run;
    }
}
