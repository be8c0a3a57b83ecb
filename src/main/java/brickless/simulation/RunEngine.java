package brickless.simulation;

import brickless.kernel.Ensemble;
import brickless.kernel.Kernel;
import brickless.kernel.ProgramEnd;
import brickless.loading.RobotContext;
import brickless.program.Program;
import brickless.trace.ReportScene;
import brickless.trace.TraceListener;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;

/**
 * One run in virtual time: programs on kernels drive a {@link Stage}, held at a {@link Gate} by whoever drives the run.
 *
 * <p>After construction everything belongs to the run's own thread (and the program's threads it hands over to, one at
 * a time); the driver touches it only while the {@link Gate} holds the run, or when it is over.
 */
final class RunEngine {
    private final Crew crew;
    private final Stage stage;
    private final List<ProgramSession> programs;
    private final ProgramLoaders loaders;
    private final Gate gate = new Gate();
    private boolean started;
    private volatile RunReport report;

    RunEngine(SimulationSettings settings, Program program, Optional<ProgramBody> body, TraceListener listener) {
        this(settings, program, body, listener, ProgramLoaders.ofRun(body.isPresent()));
    }

    /** An engine that uses given loaders and closes them in the end, or gives them back. */
    RunEngine(SimulationSettings settings, Program program, Optional<ProgramBody> body, TraceListener listener,
            ProgramLoaders loaders) {
        this.loaders = loaders;
        crew = new Crew(settings, program);
        boolean ready = false;
        try {
            List<Crew.Member> members = crew.members();
            stage = new Stage(settings, program, members, listener);
            List<RobotContext> robots = loaders.contexts(members.stream().map(Crew.Member::program).toList());
            programs = IntStream.range(0, members.size())
                    .mapToObj(i -> new ProgramSession(settings, members.get(i), stage, robots.get(i), body)).toList();
            stage.begin();
            ready = true;
        } finally {
            if (!ready) {
                loaders.close();
                crew.close();
            }
        }
    }

    long nowNanos() {
        return stage.nowNanos();
    }

    long stepNanos() {
        return stage.stepNanos();
    }

    Frame frame() {
        return stage.frame();
    }

    ReportScene scene() {
        return stage.scene();
    }

    Journey journey() {
        return stage.journey();
    }

    List<RobotSession> sessions() {
        return stage.robots();
    }

    boolean ended() {
        return gate.ended();
    }

    void add(Stimulus stimulus) {
        stage.check(stimulus);
        if (started) {
            gate.leave(() -> stage.add(stimulus));
        } else {
            stage.add(stimulus);
        }
    }

    void stop() {
        if (!started) {
            started = true;
            stage.discard();
            release(false);
            gate.end(null);
        } else if (!gate.ended()) {
            gate.leave(() -> programs.forEach(program -> program.kernel().timeUp()));
            boolean interrupted = false;
            while (!gate.ended()) {
                interrupted |= !gate.advanceTo(Long.MAX_VALUE);
            }
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /**
     * Throws a {@link CancellationException} if the calling thread is interrupted; the run is then ended and the
     * interrupt flag kept.
     */
    void advanceTo(long timeNanos) {
        if (!started) {
            started = true;
            Thread thread = new Thread(this::run, "brickless-run");
            thread.setDaemon(true);
            thread.start();
        }
        if (!gate.advanceTo(timeNanos)) {
            stop();
            Thread.currentThread().interrupt();
            throw new CancellationException("the run was interrupted");
        }
    }

    private void run() {
        Throwable problem = null;
        boolean orderly = false;
        try {
            List<Kernel> kernels = programs.stream().map(ProgramSession::kernel).toList();
            List<ProgramEnd> ends = new Ensemble(kernels, this::step).run();
            finish(ends);
            orderly = ends.stream().noneMatch(end -> end.kind() == ProgramEnd.Kind.RUNAWAY);
        } catch (RuntimeException | Error e) {
            problem = e;
        } finally {
            end(orderly, problem);
        }
    }

    private void end(boolean orderly, Throwable problem) {
        try {
            release(orderly);
        } finally {
            gate.end(problem);
        }
    }

    private void release(boolean orderly) {
        programs.forEach(ProgramSession::release);
        if (orderly) {
            loaders.giveBack();
        } else {
            loaders.close();
        }
        crew.close();
    }

    private void step(long timeNanos) {
        stage.step(timeNanos);
        endIfDecided();
        gate.pass(timeNanos);
    }

    private void endIfDecided() {
        if (stage.journey().goalReached()) {
            programs.forEach(program -> program.kernel().goalReached());
        } else if (!stage.journey().fallen().isEmpty()) {
            RobotFellException fall = new RobotFellException(stage.journey().fallen());
            programs.forEach(program -> program.kernel().fail(fall));
        }
    }

    private void finish(List<ProgramEnd> ends) {
        long switches = programs.stream().mapToLong(program -> program.kernel().contextSwitches()).sum();
        report = stage.finish(OutcomeOf.programs(stage.robots(), ends), switches, programs.get(0).kernel()
                .backendName());
    }

    RunReport report() {
        if (report == null) {
            throw new IllegalStateException("the run has not ended");
        }
        return report;
    }
}
