package brickless.simulation;

import brickless.hardware.BrickAccess;
import brickless.hardware.BrickHardware;
import brickless.kernel.LiveProcessor;
import brickless.program.Program;
import brickless.trace.Decimals;
import brickless.trace.TraceListener;
import java.io.PrintStream;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * A run paced to the wall clock, for a program whose threads are real ones. It begins when the program first touches
 * its brick and ends with the JVM; then the files of the run are written and one line tells how it went.
 *
 * <p>The stage is guarded by the lock of the {@link LiveProcessor}.
 */
final class LiveRun implements RobotSession.ProgramExit {
    /** Prepares console, screen and exception handler as the brick's menu does. */
    private static final String LAUNCHER = "lejos.internal.ev3.EV3Wrapper";

    private final Program program;
    private final PrintStream out = System.out;
    private final PrintStream err = System.err;
    private final Stage stage;
    private final LiveProcessor processor;
    private final BrickHardware brick;
    /** Why the world ended the run. */
    private Optional<String> failure = Optional.empty();

    LiveRun(SimulationSettings settings, Program program) {
        this.program = program;
        List<Crew.Member> crew = new Crew(settings, program).members();
        stage = new Stage(settings, program, crew, TraceListener.NONE);
        processor = new LiveProcessor(stage.stepNanos(), this::step);
        crew.forEach(member -> stage.enter(member, processor, true, this));
        stage.begin();
        RobotSession robot = stage.robots().get(0);
        BrickHardware sockets = robot.brick(new LiveLog(robot.console(), out, err));
        brick = new ExclusiveSockets(processor).wrap(BrickHardware.class, sockets);
    }

    /** Starts the clock and returns the brick. */
    BrickHardware start() {
        Runtime.getRuntime().addShutdownHook(new Thread(this::end, "brickless end"));
        processor.start();
        BrickAccess.attach(brick);
        prepare();
        return brick;
    }

    private static void prepare() {
        try {
            Class<?> launcher = Class.forName(LAUNCHER, true, BrickAccess.class.getClassLoader());
            MethodHandles.publicLookup().findStatic(launcher, "prepare", MethodType.methodType(void.class)).invoke();
        } catch (RuntimeException | Error e) {
            throw e;
        } catch (Throwable e) {
            throw new IllegalStateException("leJOS must lie beside Brickless", e);
        }
    }

    private void step(long timeNanos) {
        stage.step(timeNanos);
        if (failure.isEmpty() && !stage.journey().fallen().isEmpty()) {
            failure = Optional.of(new RobotFellException(stage.journey().fallen()).getMessage());
            exit(1);
        }
    }

    /** On a thread of its own: the end of the JVM waits for the lock that the caller may hold. */
    @Override
    public void exit(int status) {
        new Thread(() -> System.exit(status), "brickless exit").start();
    }

    @Override
    public void endByKeys() {
        exit(1);
    }

    /** The program is over when the JVM is. */
    @Override
    public boolean over() {
        return false;
    }

    /**
     * The JVM ends. The clock goes on, because the program's own shutdown hooks, which run at the same time, may wait
     * for a motor.
     */
    private void end() {
        processor.exclusively(() -> {
            err.println(summary(stage.finish(outcome(), 0, "live")));
            err.flush();
        });
    }

    private Outcome outcome() {
        Optional<String> error = failure.or(() -> stage.robots().get(0).console().failure());
        return new Outcome(error.isPresent() ? "failed" : "exited", Optional.empty(), processor.nowNanos(), error);
    }

    private String summary(RunReport report) {
        return String.format(Locale.ROOT, "%s in %s: %s after %s simulated seconds, drove %.2f m, %d collisions%s%s",
                program.mainClass().isEmpty() ? "program" : program.simpleName(), report.world(),
                report.outcome().kind(), Decimals.text(report.simulatedSeconds(), 3), report.distanceMetres(),
                report.collisions(), failure.map(reason -> ", " + reason).orElse(""),
                report.files().isEmpty() ? "" : ", files in " + report.files());
    }
}
