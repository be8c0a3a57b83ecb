package brickless.simulation;

import brickless.device.sensor.FloorColour;
import brickless.device.sensor.Surroundings;
import brickless.kernel.Processor;
import brickless.physics.Arena;
import brickless.physics.ArenaSettings;
import brickless.physics.Entrant;
import brickless.physics.ObstacleBody;
import brickless.program.Program;
import brickless.trace.BodySample;
import brickless.trace.ReportScene;
import brickless.trace.Sample;
import brickless.trace.TraceEvent;
import brickless.trace.TraceHeader;
import brickless.trace.TraceListener;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a run shows: the arena with its robots, stepped and recorded, whoever drives its time.
 *
 * <p>Used by one thread at a time, or within the lock of whoever drives it.
 */
final class Stage {
    /** Time between samples of the trace: 50 ms is smooth enough for replays and small enough for long runs. */
    static final long SAMPLE_NANOS = 50_000_000;

    /** Obstacles that moved less, metres or radians, count as unmoved. */
    private static final double LEAST_DISPLACEMENT = 1e-3;

    private final SimulationSettings settings;
    private final Program program;
    private final Optional<RunFolder> folder;
    private final Recorder recorder;
    private final Arena arena;
    private final Journey journey;
    private final Surroundings surroundings;
    private final Stimulator stimulator;
    private final List<RobotSession> robots = new ArrayList<>();
    private final WallClock wallClock = new WallClock();
    private volatile long now;
    private long steps;

    /** Builds the arena for a crew, whose members are to {@link #enter} it in their order. */
    Stage(SimulationSettings settings, Program program, List<Crew.Member> crew, TraceListener listener) {
        this.settings = settings;
        this.program = program;
        arena = new Arena(settings.world(),
                crew.stream().map(m -> new Entrant(m.name(), m.model(), m.start())).toList(),
                ArenaSettings.of(settings.ideal()));
        new SetupCheck(settings).check(arena);
        folder = settings.out().map(RunFolder::new);
        recorder = new Recorder(folder, new TraceHeader(program.mainClass(), settings.world().name(),
                crew.stream().map(m -> m.model().name()).toList(), settings.seed(), settings.scheduleSeed().orElse(-1),
                settings.ideal(), arena.stepNanos(), SAMPLE_NANOS), listener);
        journey = new Journey(recorder, () -> now, settings.goal().flatMap(Goal::zone));
        arena.setListener(journey);
        surroundings = new Surroundings(arena, FloorColour.of(settings.world()), settings.seed(), settings.ideal());
        stimulator = new Stimulator(settings.stimuli(), arena, recorder);
    }

    /** Adds the robot of a member. */
    RobotSession enter(Crew.Member member, Processor processor, boolean open, RobotSession.ProgramExit exit) {
        RobotSession robot = new RobotSession(settings, member, arena, surroundings, recorder, stimulator,
                processor, open, exit);
        robots.add(robot);
        return robot;
    }

    /** Everybody has entered. */
    void begin() {
        stimulator.drive(robots);
        sample(0);
    }

    long stepNanos() {
        return arena.stepNanos();
    }

    long nowNanos() {
        return now;
    }

    Journey journey() {
        return journey;
    }

    List<RobotSession> robots() {
        return robots;
    }

    void check(Stimulus stimulus) {
        SetupCheck.stimulus(stimulus, arena);
    }

    void add(Stimulus stimulus) {
        stimulator.add(stimulus);
    }

    /** One physics step, up to a time. */
    void step(long timeNanos) {
        now = timeNanos;
        steps++;
        stimulator.step(timeNanos);
        for (int i = 0; i < robots.size(); i++) {
            robots.get(i).beforeStep(timeNanos);
        }
        arena.step();
        for (int i = 0; i < robots.size(); i++) {
            robots.get(i).afterStep(timeNanos);
        }
        if (timeNanos % SAMPLE_NANOS == 0) {
            sample(timeNanos);
        }
    }

    /** Records the state after the last step; programs may have got a little further since. */
    private void sample(long timeNanos) {
        recorder.sample(new Sample(timeNanos, robots.stream().map(robot -> robot.sample(now)).toList(), bodies()));
    }

    /** Where everything is now. */
    Frame frame() {
        return new Frame(now, robots.stream().map(RobotSession::frame).toList(), bodies());
    }

    /** What to draw the run with. */
    ReportScene scene() {
        Map<String, RobotModel> models = new LinkedHashMap<>();
        robots.forEach(robot -> models.put(robot.name(), robot.model()));
        return new ReportScene(settings.world(), models);
    }

    private List<BodySample> bodies() {
        List<BodySample> bodies = new ArrayList<>();
        for (ObstacleBody obstacle : arena.obstacles()) {
            if (obstacle.movable() && obstacle.displaced()) {
                Pose2 displacement = obstacle.displacement();
                if (noticeable(displacement)) {
                    bodies.add(new BodySample(obstacle.name(), displacement));
                }
            }
        }
        return bodies;
    }

    private static boolean noticeable(Pose2 displacement) {
        return Math.abs(displacement.x()) > LEAST_DISPLACEMENT || Math.abs(displacement.y()) > LEAST_DISPLACEMENT
                || Math.abs(displacement.headingRadians()) > LEAST_DISPLACEMENT;
    }

    /** The run is over: closes the record, writes the files and makes the report. */
    RunReport finish(Outcome outcome, long contextSwitches, String processor) {
        double wallSeconds = wallClock.elapsedSeconds();
        robots.forEach(RobotSession::finish);
        if (now % SAMPLE_NANOS != 0) {
            sample(Math.max(now, outcome.timeNanos()));
        }
        recorder.event(outcome.timeNanos(), robots.get(0).name(),
                new TraceEvent.EndEvent(outcome.kind(), outcome.exitStatus().orElse(-1)));
        String hash = recorder.finish();
        RobotSession first = robots.get(0);
        List<String> notes = robots.stream().flatMap(robot -> robot.notes().stream()).toList();
        RunReport report = new RunReport(program.name(), program.mainClass(), settings.world().name(),
                first.fitted() ? "auto" : first.model().name(), settings.seed(), outcome,
                settings.goal(), wallSeconds, first.body().distanceMetres(),
                journey.collisions(), List.copyOf(journey.zones()), first.body().pose(), hash, contextSwitches,
                steps, processor, Runtime.version().toString(), notes, folder.map(RunFolder::toString).orElse(""));
        folder.ifPresent(f -> new RunFiles(f, settings, recorder, robots).write(report));
        return report;
    }

    /** The run is never to go on: removes files that were begun. */
    void discard() {
        recorder.finish();
        folder.ifPresent(RunFolder::discard);
    }
}
