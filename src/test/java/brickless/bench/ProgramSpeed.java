package brickless.bench;

import brickless.program.Program;
import brickless.simulation.Library;
import brickless.simulation.Run;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import brickless.world.DescriptionException;
import java.nio.file.Path;
import java.time.Duration;

/**
 * How fast whole programs run, in times real time. The first half of a run, start included, is measured as
 * {@code timesNewRun}, and the second half, of the same length, as the speed after warm-up: by the wall clock, by the
 * processor time of the whole JVM, and by that of its threads alone (without compiler and collector). Earlier runs of
 * the same JVM have loaded and compiled the classes. Also what a run allocates, and how long it takes to start. No
 * files are written.
 */
final class ProgramSpeed implements Measurement {
    private static final Duration BEGINNING = Duration.ofMillis(2);

    private final String mainClass;
    private final String world;

    ProgramSpeed(Class<?> program, String world) {
        this.mainClass = program.getName();
        this.world = world;
    }

    @Override
    public Figures measure(Effort effort) throws Exception {
        long begin = System.nanoTime();
        Simulation simulation = simulation(2 * effort.simulatedSeconds());
        while (System.nanoTime() - begin < effort.warmUpMillis() * 1_000_000) {
            round(simulation, effort);
        }
        Figures[] rounds = new Figures[effort.rounds()];
        for (int i = 0; i < rounds.length; i++) {
            rounds[i] = round(simulation, effort);
        }
        return medians(rounds);
    }

    private Simulation simulation(int seconds) throws DescriptionException {
        Library library = new Library(Path.of("no-files-here"));
        return new Simulation(SimulationSettings.builder(library.world(world)).robot(library.robot("educator"))
                .limit(Duration.ofSeconds(seconds)).build());
    }

    private Figures round(Simulation simulation, Effort effort) {
        Duration half = Duration.ofSeconds(effort.simulatedSeconds());
        HostReading start = HostReading.now();
        Run run = simulation.start(Program.onClassPath(mainClass));
        run.advance(BEGINNING);
        HostReading begun = HostReading.now();
        run.advance(half.minus(BEGINNING));
        HostReading warm = HostReading.now();
        run.advance(half.minus(BEGINNING));
        HostReading late = HostReading.now();
        run.toEnd();
        if (!run.outcome().kind().equals("time-limit")) {
            throw new IllegalStateException(run.report().text());
        }
        double seconds = half.minus(BEGINNING).toMillis() / 1e3;
        return new Figures().put("timesWall", seconds / late.wallSecondsSince(warm))
                .put("timesCpu", seconds / late.processSecondsSince(warm))
                .put("timesThreads", seconds / late.threadSecondsSince(warm))
                .put("timesNewRun", half.toSeconds() / warm.wallSecondsSince(start))
                .put("kilobytesPerSecond", (late.allocatedBytes() - warm.allocatedBytes()) / 1e3 / seconds)
                .put("startMillis", begun.wallSecondsSince(start) * 1e3)
                .put("switchesPerSecond", run.report().contextSwitches() / (2.0 * half.toSeconds()));
    }

    static Figures medians(Figures... rounds) {
        Figures medians = new Figures();
        for (String name : rounds[0].values().keySet()) {
            double[] values = new double[rounds.length];
            for (int i = 0; i < values.length; i++) {
                values[i] = rounds[i].get(name);
            }
            medians.put(name, Figures.median(values));
        }
        return medians;
    }
}
