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
 * How fast whole programs run: simulated time over wall time and over processor time, what they allocate, and how long a run takes to
 * start. A run counts from its start to its end, report included; no files are written.
 */
final class ProgramSpeed implements Measurement {
    private static final Duration BEGINNING = Duration.ofMillis(2);

    private final String mainClass;
    private final String world;

    ProgramSpeed(Class<?> program, String world) {
        this.mainClass = program.getName();
        this.world = world;
    }

    @Override public Figures measure(Effort effort) throws Exception {
        long begin = System.nanoTime();
        Simulation simulation = simulation(effort.simulatedSeconds());
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
        HostReading start = HostReading.now();
        Run run = simulation.start(Program.onClassPath(mainClass));
        run.advance(BEGINNING);
        HostReading steady = HostReading.now();
        Duration middle = Duration.ofSeconds(effort.simulatedSeconds()).minus(BEGINNING.multipliedBy(2));
        run.advance(middle);
        HostReading late = HostReading.now();
        run.toEnd();
        HostReading end = HostReading.now();
        if (!run.outcome().kind().equals("time-limit")) {
            throw new IllegalStateException(run.report().text());
        }
        return new Figures().put("timesWall", effort.simulatedSeconds() / end.wallSecondsSince(start))
                .put("timesCpu", effort.simulatedSeconds() / end.processSecondsSince(start))
                .put("kilobytesPerSecond", (late.allocatedBytes() - steady.allocatedBytes()) / 1e3 / (middle.toMillis() / 1e3))
                .put("startMillis", steady.wallSecondsSince(start) * 1e3)
                .put("switchesPerSecond", (double) run.report().contextSwitches() / effort.simulatedSeconds());
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
