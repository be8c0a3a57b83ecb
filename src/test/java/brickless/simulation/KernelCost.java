package brickless.simulation;

import brickless.kernel.BackendChoice;
import brickless.kernel.Ensemble;
import brickless.kernel.Kernel;
import brickless.kernel.KernelSettings;
import brickless.program.Program;
import brickless.trace.TraceListener;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import programs.robots.TwoPollers;

/**
 * Processor time that kernel and program take without physics: {@code KernelCost SECONDS auto|threads|continuations}. The robot
 * has all its devices but its world stands still. On JDK 25, at most 2 ms per simulated second are wanted.
 */
public final class KernelCost {
    private static final int ROUNDS = 5;

    private KernelCost() {}

    /** Runs the benchmark. */
    public static void main(String[] args) throws Exception {
        long seconds = Long.parseLong(args[0]);
        BackendChoice backend = BackendChoice.valueOf(args[1].toUpperCase(Locale.ROOT));
        System.out.println("JDK " + Runtime.version());
        for (int round = 0; round < ROUNDS; round++) {
            measure(seconds, backend);
        }
    }

    private static void measure(long seconds, BackendChoice backend) throws Exception {
        Program program = Program.onClassPath(TwoPollers.class.getName());
        SimulationSettings settings = ExamplePrograms.settings("pen").build();
        List<Crew.Member> crew = new Crew(settings, program).members();
        Stage stage = new Stage(settings, program, crew, TraceListener.NONE);
        Kernel kernel = new Kernel(KernelSettings.defaults().withLimitNanos(seconds * 1_000_000_000L).withBackend(backend)
                .withStepNanos(stage.stepNanos()));
        RobotSession robot = stage.enter(crew.get(0), kernel, true, new NeverEnding());
        RobotRealm realm = new RobotRealm(program, kernel, robot.brick(robot.console()), Optional.empty());
        stage.begin();
        long process = processNanos();
        long wall = System.nanoTime();
        new Ensemble(List.of(kernel), time -> { }).run();
        double perSecond = 1e6 * seconds;
        System.out.printf(Locale.ROOT, "%s: %.2f ms of CPU (JIT compiler included), %.2f ms of wall time, %d switches per simulated second%n",
                kernel.backendName(), (processNanos() - process) / perSecond, (System.nanoTime() - wall) / perSecond,
                kernel.contextSwitches() / seconds);
        realm.release();
    }

    private static long processNanos() {
        return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime();
    }

    private static final class NeverEnding implements RobotSession.ProgramExit {
        @Override public void exit(int status) {
            throw new IllegalStateException("the program must not end");
        }

        @Override public void endByKeys() {
            throw new IllegalStateException("the program must not end");
        }

        @Override public boolean over() {
            return false;
        }
    }
}
