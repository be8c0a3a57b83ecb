package brickless.simulation;

import brickless.physics.Arena;
import brickless.physics.ObstacleBody;
import brickless.physics.RobotBody;
import brickless.trace.TraceEvent;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;

/** Does to the robots and the world what the stimuli say, at physics steps, in order of time. Used by the running step only. */
final class Stimulator {
    /** How long a clap is heard. */
    private static final long CLAP_NANOS = 100_000_000;

    private record Due(long atNanos, long order, boolean keyPress, Runnable action) {}

    private final PriorityQueue<Due> due = new PriorityQueue<>(Comparator.comparingLong(Due::atNanos).thenComparingLong(Due::order));
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

    /** Whether somebody is still going to press a key. */
    boolean keyPressesToCome() {
        return pressesToCome > 0;
    }

    void add(Stimulus stimulus) {
        boolean press = stimulus instanceof Stimulus.Press;
        pressesToCome += press ? 1 : 0;
        due.add(new Due(stimulus.atNanos(), order++, press, () -> begin(stimulus)));
    }

    void step(long nowNanos) {
        while (!due.isEmpty() && due.peek().atNanos() <= nowNanos) {
            Due next = due.poll();
            pressesToCome -= next.keyPress() ? 1 : 0;
            next.action().run();
        }
    }

    private void later(long atNanos, Runnable action) {
        due.add(new Due(atNanos, order++, false, action));
    }

    private void begin(Stimulus stimulus) {
        RobotSession first = sessions.get(0);
        recorder.event(stimulus.atNanos(), first.name(), new TraceEvent.StimulusEvent(stimulus.text()));
        if (stimulus instanceof Stimulus.Press press) {
            first.panel().keys().press(press.keyMask());
            later(press.atNanos() + press.forNanos(), () -> first.panel().keys().release(press.keyMask()));
        } else if (stimulus instanceof Stimulus.Push push) {
            first.devices().sensor(push.port()).push(true);
            later(push.atNanos() + push.forNanos(), () -> first.devices().sensor(push.port()).push(false));
        } else if (stimulus instanceof Stimulus.Remote remote) {
            sessions.forEach(session -> session.devices().remote(remote.channel(), remote.code()));
            later(remote.atNanos() + remote.forNanos(), () -> sessions.forEach(session -> session.devices().remote(remote.channel(), 0)));
        } else if (stimulus instanceof Stimulus.Clap clap) {
            arena.sound().setDecibels(clap.decibels());
            later(clap.atNanos() + CLAP_NANOS, () -> arena.sound().setDecibels(0));
        } else if (stimulus instanceof Stimulus.Battery battery) {
            first.devices().battery().setOpenVolts(battery.volts());
        } else if (stimulus instanceof Stimulus.Move move) {
            move(move);
        } else if (stimulus instanceof Stimulus.Remove remove) {
            arena.obstacle(remove.target()).ifPresent(arena::remove);
        }
    }

    private void move(Stimulus.Move move) {
        Optional<RobotBody> robot = arena.robot(move.target());
        Optional<ObstacleBody> obstacle = arena.obstacle(move.target());
        robot.ifPresent(body -> arena.move(body, move.pose()));
        obstacle.ifPresent(body -> arena.move(body, move.pose()));
    }
}
