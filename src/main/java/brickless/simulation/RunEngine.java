package brickless.simulation;

import brickless.device.sensor.FloorColour;
import brickless.device.sensor.Surroundings;
import brickless.kernel.Ensemble;
import brickless.kernel.ProgramEnd;
import brickless.physics.Arena;
import brickless.physics.ArenaSettings;
import brickless.physics.Entrant;
import brickless.physics.ObstacleBody;
import brickless.program.Program;
import brickless.trace.BodySample;
import brickless.trace.Sample;
import brickless.trace.TraceEvent;
import brickless.trace.TraceHeader;
import brickless.world.Pose2;
import brickless.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * One run: builds the arena and the robots, steps them, records, and closes the books.
 *
 * <p>After construction everything belongs to the run's own thread (and the program's threads it hands over to, one at a time); the driver
 * touches it only while the {@link Gate} holds the run, or when it is over.
 */
final class RunEngine {
    /** Time between samples of the trace: 50 ms is smooth enough for replays and small enough for long runs. */
    static final long SAMPLE_NANOS = 50_000_000;

    private static final Pose2 NOWHERE = new Pose2(0, 0, 0);
    /** Obstacles that moved less, metres or radians, count as unmoved. */
    private static final double LEAST_DISPLACEMENT = 1e-3;

    private final SimulationSettings settings;
    private final Program program;
    private final Optional<RunFolder> folder;
    private final Recorder recorder;
    private final Arena arena;
    private final Journey journey;
    private final List<RobotSession> sessions;
    private final Stimulator stimulator;
    private final Gate gate = new Gate();
    private final WallClock wallClock = new WallClock();
    private volatile long now;
    private boolean started;
    private volatile RunReport report;

    RunEngine(SimulationSettings settings, Program program, Optional<ProgramBody> body) {
        this.settings = settings;
        this.program = program;
        World world = settings.world();
        List<Crew.Member> crew = new Crew(settings, program).members();
        arena = new Arena(world, crew.stream().map(m -> new Entrant(m.name(), m.model(), m.start())).toList(), ArenaSettings.of(settings.ideal()));
        new SetupCheck(settings).check(arena);
        folder = settings.out().map(RunFolder::new);
        recorder = new Recorder(folder, new TraceHeader(program.mainClass(), world.name(), crew.stream().map(m -> m.model().name()).toList(),
                settings.seed(), settings.scheduleSeed().orElse(-1), settings.ideal(), arena.stepNanos(), SAMPLE_NANOS));
        journey = new Journey(recorder, () -> now, settings.goal().flatMap(Goal::zone));
        arena.setListener(journey);
        Surroundings surroundings = new Surroundings(arena, FloorColour.of(world), settings.seed(), settings.ideal());
        stimulator = new Stimulator(settings.stimuli(), arena, recorder);
        sessions = crew.stream().map(member -> new RobotSession(settings, member, arena, surroundings, recorder, stimulator, body)).toList();
        stimulator.drive(sessions);
        sample();
    }

    long nowNanos() {
        return now;
    }

    Journey journey() {
        return journey;
    }

    List<RobotSession> sessions() {
        return sessions;
    }

    boolean ended() {
        return gate.ended();
    }

    void add(Stimulus stimulus) {
        SetupCheck.stimulus(stimulus, arena);
        gate.leave(() -> stimulator.add(stimulus));
    }

    void stop() {
        if (!started) {
            started = true;
            recorder.finish();
            folder.ifPresent(RunFolder::discard);
            sessions.forEach(RobotSession::release);
            gate.end(null);
        } else if (!gate.ended()) {
            gate.leave(() -> sessions.forEach(session -> session.kernel().timeUp()));
            gate.advanceTo(Long.MAX_VALUE);
        }
    }

    void advanceTo(long timeNanos) {
        if (!started) {
            started = true;
            Thread thread = new Thread(this::run, "brickless-run");
            thread.setDaemon(true);
            thread.start();
        }
        gate.advanceTo(timeNanos);
    }

    private void run() {
        try {
            List<ProgramEnd> ends = new Ensemble(sessions.stream().map(RobotSession::kernel).toList(), this::step).run();
            finish(ends);
            gate.end(null);
        } catch (RuntimeException | Error e) {
            gate.end(e);
        } finally {
            sessions.forEach(RobotSession::release);
        }
    }

    private void step(long timeNanos) {
        now = timeNanos;
        stimulator.step(timeNanos);
        for (int i = 0; i < sessions.size(); i++) {
            sessions.get(i).beforeStep(timeNanos);
        }
        arena.step();
        for (int i = 0; i < sessions.size(); i++) {
            sessions.get(i).afterStep(timeNanos);
        }
        if (timeNanos % SAMPLE_NANOS == 0) {
            sample();
        }
        endIfDecided();
        gate.pass(timeNanos);
    }

    private void endIfDecided() {
        if (journey.goalReached()) {
            sessions.forEach(session -> session.kernel().goalReached());
        } else if (!journey.fallen().isEmpty()) {
            RobotFellException fall = new RobotFellException(journey.fallen());
            sessions.forEach(session -> session.kernel().fail(fall));
        }
    }

    private void sample() {
        List<BodySample> bodies = new ArrayList<>();
        for (ObstacleBody obstacle : arena.obstacles()) {
            Pose2 displacement = obstacle.description().movable() ? obstacle.displacement() : NOWHERE;
            if (displaced(displacement)) {
                bodies.add(new BodySample(obstacle.name(), displacement));
            }
        }
        recorder.sample(new Sample(now, sessions.stream().map(session -> session.sample(now)).toList(), bodies));
    }

    private static boolean displaced(Pose2 displacement) {
        return Math.abs(displacement.x()) > LEAST_DISPLACEMENT || Math.abs(displacement.y()) > LEAST_DISPLACEMENT
                || Math.abs(displacement.headingRadians()) > LEAST_DISPLACEMENT;
    }

    private void finish(List<ProgramEnd> ends) {
        double wallSeconds = wallClock.elapsedSeconds();
        for (int i = 0; i < ends.size(); i++) {
            sessions.get(i).finish(ends.get(i));
        }
        if (now % SAMPLE_NANOS != 0) {
            sample();
        }
        Outcome outcome = OutcomeOf.programs(sessions, ends);
        recorder.event(outcome.timeNanos(), sessions.get(0).name(), new TraceEvent.EndEvent(outcome.kind(), outcome.exitStatus().orElse(-1)));
        report = report(outcome, wallSeconds, recorder.finish());
        folder.ifPresent(f -> new RunFiles(f, settings, recorder, sessions).write(report));
    }

    private RunReport report(Outcome outcome, double wallSeconds, String hash) {
        RobotSession first = sessions.get(0);
        Pose2 pose = first.body().pose();
        List<String> notes = sessions.stream().flatMap(session -> session.notes().stream()).toList();
        return new RunReport(program.name(), program.mainClass(), settings.world().name(), first.model().name(), settings.seed(), outcome,
                settings.goal().map(goal -> !goal.reachedBy(outcome)).orElse(false), wallSeconds, first.body().distanceMetres(),
                journey.collisions(), List.copyOf(journey.zones()), pose, hash,
                sessions.stream().mapToLong(session -> session.kernel().contextSwitches()).sum(), first.kernel().physicsSteps(),
                first.kernel().backendName(), Runtime.version().toString(), notes, folder.map(RunFolder::toString).orElse(""));
    }

    RunReport report() {
        if (report == null) {
            throw new IllegalStateException("the run has not ended");
        }
        return report;
    }
}
