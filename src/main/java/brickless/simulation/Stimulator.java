package brickless.simulation;

import brickless.physics.Arena;
import brickless.physics.ObstacleBody;
import brickless.physics.RobotBody;
import brickless.trace.TraceEvent;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;

/**
 * Does to the robots and the world what the stimuli say, at physics steps, in order of time; at one time, what ends
 * comes before what begins, however late it was added. Used by the running step only.
 */
final class Stimulator {
    /** How long a clap is heard. */
    private static final long CLAP_NANOS = 100_000_000;

    private record Due(long atNanos, boolean begins, long order, boolean keyPress, Runnable action) {}

    private final PriorityQueue<Due> due = new PriorityQueue<>(
            Comparator.comparingLong(Due::atNanos).thenComparing(Due::begins).thenComparingLong(Due::order));
    private final Arena arena;
    private final Recorder recorder;
    private final List<Stimulus> initial;
    private List<RobotSession> sessions = List.of();
    private long order;
    private int pressesToCome;

    Stimulator(List<Stimulus> stimuli, Arena arena, Recorder recorder) {
        this.initial = stimuli;
        this.arena = arena;
        this.recorder = recorder;
    }

    /** Says whose robots these are. */
    void drive(List<RobotSession> robots) {
        sessions = robots;
        initial.forEach(this::add);
    }

    /** Whether somebody plans to press a key. A key that is held for an unknown time was not planned. */
    boolean keyPressesToCome() {
        return pressesToCome > 0;
    }

    /** Whether any stimulus is still to come or to end. */
    boolean hasMoreToDo() {
        return !due.isEmpty();
    }

    void add(Stimulus stimulus) {
        boolean press = (stimulus instanceof Stimulus.On on ? on.what() : stimulus) instanceof Stimulus.Press;
        pressesToCome += press ? 1 : 0;
        due.add(new Due(stimulus.atNanos(), true, order++, press, () -> begin(stimulus)));
    }

    void step(long nowNanos) {
        while (!due.isEmpty() && due.peek().atNanos() <= nowNanos) {
            Due next = due.poll();
            pressesToCome -= next.keyPress() ? 1 : 0;
            next.action().run();
        }
    }

    private void later(long atNanos, Runnable action) {
        due.add(new Due(atNanos, false, order++, false, action));
    }

    private void begin(Stimulus stimulus) {
        List<RobotSession> concerned = stimulus instanceof Stimulus.On on
                ? sessions.stream().filter(session -> session.name().equals(on.robot())).toList() : sessions;
        RobotSession robot = concerned.get(0);
        recorder.event(stimulus.atNanos(), robot.name(), new TraceEvent.StimulusEvent(stimulus.text()));
        apply(stimulus instanceof Stimulus.On on ? on.what() : stimulus, robot, concerned);
    }

    /** Does it to a robot, or with the remote to all robots that see it. */
    private void apply(Stimulus stimulus, RobotSession robot, List<RobotSession> seeing) {
        if (stimulus instanceof Stimulus.Press press) {
            holdFor(new Stimulus.Key(press.keyMask()), press.atNanos() + press.forNanos(), robot, seeing);
        } else if (stimulus instanceof Stimulus.Push push) {
            holdFor(new Stimulus.TouchSensor(push.port()), push.atNanos() + push.forNanos(), robot, seeing);
        } else if (stimulus instanceof Stimulus.Remote remote) {
            holdFor(new Stimulus.RemoteButton(remote.channel(), remote.code()), remote.atNanos() + remote.forNanos(),
                    robot, seeing);
        } else if (stimulus instanceof Stimulus.Hold hold) {
            hold(hold.what(), true, robot, seeing);
        } else if (stimulus instanceof Stimulus.Release release) {
            hold(release.what(), false, robot, seeing);
        } else if (stimulus instanceof Stimulus.Clap clap) {
            arena.sound().setDecibels(clap.decibels());
            later(clap.atNanos() + CLAP_NANOS, () -> arena.sound().setDecibels(0));
        } else if (stimulus instanceof Stimulus.Battery battery) {
            robot.devices().battery().setOpenVolts(battery.volts());
        } else if (stimulus instanceof Stimulus.Move move) {
            move(move);
        } else if (stimulus instanceof Stimulus.Remove remove) {
            arena.obstacle(remove.target()).ifPresent(arena::remove);
        }
    }

    private void holdFor(Stimulus.Holdable what, long untilNanos, RobotSession robot, List<RobotSession> seeing) {
        hold(what, true, robot, seeing);
        later(untilNanos, () -> hold(what, false, robot, seeing));
    }

    private static void hold(Stimulus.Holdable what, boolean down, RobotSession robot, List<RobotSession> seeing) {
        if (what instanceof Stimulus.Key key && down) {
            robot.panel().keys().press(key.mask());
        } else if (what instanceof Stimulus.Key key) {
            robot.panel().keys().release(key.mask());
        } else if (what instanceof Stimulus.TouchSensor touch) {
            robot.devices().sensor(touch.port()).push(down);
        } else if (what instanceof Stimulus.RemoteButton button) {
            seeing.forEach(session -> session.devices().remote(button.channel(), down ? button.code() : 0));
        }
    }

    private void move(Stimulus.Move move) {
        Optional<RobotBody> robot = arena.robot(move.target());
        Optional<ObstacleBody> obstacle = arena.obstacle(move.target());
        robot.ifPresent(body -> arena.move(body, move.pose()));
        obstacle.ifPresent(body -> arena.move(body, move.pose()));
    }
}
