package brickless.bench;

import brickless.program.Program;
import brickless.simulation.Run;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;
import java.time.Duration;
import programs.speed.Bumper;

/** Many robots in one world, each with a program of its own: speed, and memory for each. */
final class ManyRobots implements Measurement {
    private static final Duration BEGINNING = Duration.ofMillis(100);
    /** A few robots run as long as one program does, a thousand for ten seconds. */
    private static final int ROBOT_SECONDS = 10_000;

    private static final String HEAP = "heapKilobytesPerRobot";
    private static final String CLASSES = "classesKilobytesPerRobot";

    private final int robots;

    ManyRobots(int robots) {
        this.robots = robots;
    }

    @Override
    public Figures measure(Effort effort) throws Exception {
        int seconds = Math.max(1,
                Math.min(effort.simulatedSeconds(), effort.nest() ? Math.max(10, ROBOT_SECONDS / robots / 2) : 1));
        long begin = System.nanoTime();
        Figures first = round(seconds);
        Figures last = first;
        for (int i = 1; i < effort.rounds() && System.nanoTime() - begin < 2 * effort.warmUpMillis() * 1_000_000; i++) {
            last = round(seconds);
        }
        // Only in the first run are the classes new.
        for (String memory : new String[] {HEAP, CLASSES}) {
            last.put(memory, first.get(memory));
        }
        return last;
    }

    /** The first half of a run as {@code timesNewRun}, and the second half, of the same length, as the others. */
    private Figures round(int seconds) {
        Simulation simulation = new Simulation(SimulationSettings.builder(new RobotGrid(robots).world())
                .robot(RobotGrid.model()).limit(Duration.ofSeconds(2L * seconds)).build());
        double[] before = memory();
        HostReading start = HostReading.now();
        Run run = simulation.start(Program.onClassPath(Bumper.class.getName()));
        run.advance(BEGINNING);
        HostReading begun = HostReading.now();
        double[] with = memory();
        HostReading first = HostReading.now();
        run.advance(Duration.ofSeconds(seconds).minus(BEGINNING));
        HostReading warm = HostReading.now();
        run.advance(Duration.ofSeconds(seconds).minus(BEGINNING));
        HostReading late = HostReading.now();
        run.toEnd();
        if (!run.outcome().kind().equals("time-limit")) {
            throw new IllegalStateException(run.report().text());
        }
        double simulated = seconds - BEGINNING.toMillis() / 1e3;
        return new Figures().put("seconds", seconds).put("timesWall", simulated / late.wallSecondsSince(warm))
                .put("timesCpu", simulated / late.processSecondsSince(warm))
                .put("timesNewRun", simulated / warm.wallSecondsSince(first))
                .put("microsPerRobotStep", late.processSecondsSince(warm) * 1e6 / (simulated * 500 * robots))
                .put("startMillis", begun.wallSecondsSince(start) * 1e3)
                .put(HEAP, (with[0] - before[0]) / 1e3 / robots)
                .put(CLASSES, (with[1] - before[1]) / 1e3 / robots);
    }

    /** Heap in use after a collection, and memory outside it, bytes. */
    private static double[] memory() {
        MemoryMXBean memory = ManagementFactory.getMemoryMXBean();
        System.gc();
        return new double[] {memory.getHeapMemoryUsage().getUsed(), memory.getNonHeapMemoryUsage().getUsed()};
    }
}
