package brickless.viewer;

import brickless.simulation.RunReport;
import brickless.simulation.SetupException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/**
 * Drives the run: one thread that advances it in small steps as the wall clock asks for, does what viewers command, and
 * tells them what happens. Everything but the queue of tasks belongs to that thread.
 */
final class Driver implements Runnable {
    /** Frames follow each other at this distance, wall time: 30 a second. */
    private static final long TICK_NANOS = 1_000_000_000 / 30;
    /** Longest simulated time between two looks at the clock. */
    private static final long QUANTUM_NANOS = 20_000_000;
    private static final int MOST_WAITING_TASKS = 1_000;

    /** Something to be done by the driver's thread, and who waits for it. */
    private record Task<T>(Supplier<T> work, CompletableFuture<T> done) {
        void perform() {
            try {
                done.complete(work.get());
            } catch (RefusedException e) {
                done.completeExceptionally(e);
            }
        }

        void refuse() {
            done.completeExceptionally(new RefusedException("the run is busy, or the view is being closed"));
        }
    }

    private final BlockingQueue<Task<?>> tasks = new ArrayBlockingQueue<>(MOST_WAITING_TASKS);
    private final Audience audience = new Audience();
    private final Pacer pacer;
    private final RateMeter meter = new RateMeter();
    private final CompletableFuture<Optional<RunReport>> result = new CompletableFuture<>();
    private Session session;
    private boolean playing = true;
    private boolean everWatched;
    private boolean stopping;
    private List<Path> changed = List.of();
    private Optional<String> message = Optional.empty();
    private long shownNanos = -1;
    private boolean shownEnded;
    private long nextTickNanos = System.nanoTime();

    /** Drives a session that has not begun; it begins when the first viewer is there. */
    Driver(Session first, double speed) {
        session = first;
        pacer = new Pacer(speed);
    }

    /**
     * The report of the last run, once it is over; empty if it never began. Completed exceptionally if the simulation
     * itself failed.
     */
    CompletableFuture<Optional<RunReport>> result() {
        return result;
    }

    // ---- any thread

    /** Has something done by the driver's thread; what it throws is the result. */
    <T> CompletableFuture<T> submit(Supplier<T> task) {
        Task<T> entry = new Task<>(task, new CompletableFuture<>());
        if (!tasks.offer(entry) || result.isDone()) {
            entry.refuse();
        }
        return entry.done();
    }

    CompletableFuture<Void> submit(Runnable task) {
        return submit(() -> {
            task.run();
            return null;
        });
    }

    // ---- tasks, on the driver's thread

    /** A viewer begins, or begins anew. */
    void join(Mailbox mailbox) {
        tellNews();
        if (!everWatched) {
            everWatched = true;
            pacer.restart(System.nanoTime(), session.nowNanos());
        }
        audience.join(mailbox);
        begin(mailbox);
        tellState();
    }

    /** A viewer has gone; unless it held something, the run does not notice. */
    void leave(Mailbox mailbox) {
        audience.leave(mailbox);
        touch(() -> {
            session.letGo(mailbox.viewer());
            if (audience.isEmpty()) {
                session.letGo(Holds.ANYBODY);
            }
        });
    }

    void perform(Command command) {
        if (command instanceof Command.Pause) {
            playing = false;
        } else if (command instanceof Command.Play) {
            session.refuseIfEnded();
            play();
        } else if (command instanceof Command.Step step) {
            session.refuseIfEnded();
            playing = false;
            advance(step.nanos());
        } else if (command instanceof Command.SetSpeed speed) {
            pacer.setSpeed(speed.speed(), System.nanoTime(), session.nowNanos());
        } else if (command instanceof Command.Touch touch) {
            touch(() -> session.touch(touch.words()));
        } else if (command instanceof Command.Hold hold) {
            touch(() -> session.hold(hold));
        }
        message = Optional.empty();
        tellNews();
        tellState();
    }

    private void play() {
        if (!playing) {
            playing = true;
            pacer.restart(System.nanoTime(), session.nowNanos());
        }
    }

    /** Whoever touches a run that is held wants to see it: it goes on by one step if there was anything to do. */
    private void touch(Runnable action) {
        int before = session.touches();
        action.run();
        if (session.touches() > before && !playing && !session.ended()) {
            advance(session.run().step().toNanos());
            tellNews();
            tellState();
        }
    }

    /** Ends the session and puts a new one in its place; it begins at once if somebody watches. */
    void replace(RunSource.Prepared prepared) {
        session.close();
        try {
            session = new Session(session.number() + 1, prepared);
        } catch (SetupException e) {
            say(e.getMessage());
            throw new RefusedException(e.getMessage());
        }
        changed = List.of();
        message = Optional.empty();
        playing = true;
        shownEnded = false;
        pacer.begin(System.nanoTime());
        meter.restart();
        audience.all().forEach(this::begin);
        tellState();
    }

    /** Tells people something. */
    void say(String text) {
        message = Optional.of(text);
        tellState();
    }

    /** Files that were changed since the session was prepared. */
    void filesChanged(List<Path> files) {
        if (!files.equals(changed)) {
            changed = files;
            tellState();
        }
    }

    Session session() {
        return session;
    }

    /** Ends the run and then this thread. */
    void stop() {
        stopping = true;
    }

    // ---- the thread

    @Override
    public void run() {
        try {
            while (!stopping) {
                performAll(tasks.poll(waitNanos(), TimeUnit.NANOSECONDS));
                tick();
            }
            session.close();
            tellNews();
            tellState();
            result.complete(session.report());
        } catch (InterruptedException | RuntimeException | Error e) {
            result.completeExceptionally(e);
        } finally {
            audience.close();
            for (Task<?> late = tasks.poll(); late != null; late = tasks.poll()) {
                late.refuse();
            }
        }
    }

    private void performAll(Task<?> first) {
        for (Task<?> next = first; next != null; next = stopping ? null : tasks.poll()) {
            next.perform();
        }
    }

    private boolean advancing() {
        return playing && everWatched && !session.ended();
    }

    private long waitNanos() {
        long next = advancing() ? Math.min(nextTickNanos, meter.nextReportNanos()) : meter.nextReportNanos();
        return Math.max(0, next - System.nanoTime());
    }

    private void tick() {
        long now = System.nanoTime();
        if (advancing() && now >= nextTickNanos) {
            nextTickNanos = Math.max(nextTickNanos + TICK_NANOS, now);
            catchUp(now);
            tellNews();
        }
        if (session.ended() != shownEnded || now >= meter.nextReportNanos()) {
            tellState();
        }
    }

    private void catchUp(long startNanos) {
        long due = pacer.due(startNanos);
        long step = session.run().step().toNanos();
        long now = startNanos;
        while (!session.ended() && due - session.nowNanos() >= step && now - startNanos < TICK_NANOS) {
            advance(Math.min(QUANTUM_NANOS, due - session.nowNanos()));
            now = System.nanoTime();
        }
        if (pacer.reached(now, session.nowNanos())) {
            playing = false;
            say("The run was paused after another 10 simulated hours. "
                    + "Its record grows with its time; play lets it go on.");
        }
    }

    private void advance(long nanos) {
        session.advance(nanos);
    }

    private void begin(Mailbox mailbox) {
        session.tap().skip();
        mailbox.begin(Messages.begin(session, mailbox.viewer()));
        mailbox.frame(Messages.frame(session.run().frame()));
        shownNanos = session.nowNanos();
    }

    /** What happened since the last call. */
    private void tellNews() {
        if (audience.isEmpty()) {
            session.tap().skip();
            return;
        }
        List<String> events = session.tap().takeEvents();
        if (!events.isEmpty()) {
            audience.tell(Mailbox::event, Messages.events(events));
        }
        session.tap().takeSample().ifPresent(sample -> audience.tell(Mailbox::sample, Messages.sample(sample)));
        if (session.nowNanos() != shownNanos) {
            shownNanos = session.nowNanos();
            audience.tell(Mailbox::frame, Messages.frame(session.run().frame()));
        }
    }

    private void tellState() {
        shownEnded = session.ended();
        double rate = meter.report(System.nanoTime(), session.nowNanos());
        audience.tell(Mailbox::state,
                Messages.state(session, playing && !session.ended(), pacer.speed(), rate, changed, message));
    }
}
