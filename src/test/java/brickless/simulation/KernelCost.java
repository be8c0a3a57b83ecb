package brickless.simulation;

import brickless.bench.Effort;
import brickless.bench.Figures;
import brickless.bench.Measurement;
import brickless.kernel.Ensemble;
import brickless.kernel.Kernel;
import brickless.kernel.KernelSettings;
import brickless.program.Program;
import brickless.trace.TraceListener;
import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Optional;
import programs.robots.TwoPollers;

/**
 * Processor time that kernel and program take without physics: the robot has all its devices but its world stands
 * still. On JDK 25, at most 2 ms per simulated second are wanted.
 */
public final class KernelCost implements Measurement {
    @Override
    public Figures measure(Effort effort) throws Exception {
        long begin = System.nanoTime();
        Figures last = round(effort.simulatedSeconds());
        while (System.nanoTime() - begin < effort.warmUpMillis() * 1_000_000) {
            last = round(effort.simulatedSeconds());
        }
        return last;
    }

    private static Figures round(long seconds) throws Exception {
        Program program = Program.onClassPath(TwoPollers.class.getName());
        SimulationSettings settings = ExamplePrograms.settings("pen").build();
        List<Crew.Member> crew = new Crew(settings, program).members();
        Stage stage = new Stage(settings, program, crew, TraceListener.NONE);
        Kernel kernel = new Kernel(KernelSettings.defaults().withLimitNanos(seconds * 1_000_000_000L)
                .withStepNanos(stage.stepNanos()));
        RobotSession robot = stage.enter(crew.get(0), kernel, true, new NeverEnding());
        ProgramLoaders loaders = new ProgramLoaders(ProgramLoaders.Sharing.NONE);
        RobotRealm realm = new RobotRealm(loaders.contexts(List.of(program)).get(0), program.mainClass(), kernel,
                robot.brick(robot.console()), Optional.empty());
        stage.begin();
        long process = processNanos();
        long wall = System.nanoTime();
        new Ensemble(List.of(kernel), time -> { }).run();
        double perSecond = 1e6 * seconds;
        Figures figures = new Figures().put("cpuMillisPerSecond", (processNanos() - process) / perSecond)
                .put("wallMillisPerSecond", (System.nanoTime() - wall) / perSecond)
                .put("switchesPerSecond", (double) kernel.contextSwitches() / seconds);
        realm.release();
        loaders.close();
        return figures;
    }

    private static long processNanos() {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime();
    }

    private static final class NeverEnding implements RobotSession.ProgramExit {
        @Override
        public void exit(int status) {
            throw new IllegalStateException("the program must not end");
        }

        @Override
        public void endByKeys() {
            throw new IllegalStateException("the program must not end");
        }

        @Override
        public boolean over() {
            return false;
        }
    }
}
