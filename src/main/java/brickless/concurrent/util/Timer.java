package brickless.concurrent.util;

import brickless.concurrent.locks.Deadline;
import java.util.ArrayList;
import java.util.Date;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * {@code java.util.Timer} on a virtual thread; timers are numbered per robot. Unlike the original, whose thread may end
 * when the garbage collector finds the timer unused, this one runs until it is cancelled (or, as a daemon, until the
 * program ends).
 */
public class Timer {
    private static final AtomicInteger TIMERS = new AtomicInteger();

    private final Object monitor = new Object();
    // Guarded by the monitor:
    private final List<TimerTask> tasks = new ArrayList<>();
    private boolean cancelled;

    /** Creates a timer whose thread is not a daemon. */
    public Timer() {
        this(false);
    }

    /** Creates a timer. */
    public Timer(boolean isDaemon) {
        this("Timer-" + TIMERS.getAndIncrement(), isDaemon);
    }

    /** Creates a timer whose thread has that name and is not a daemon. */
    public Timer(String name) {
        this(name, false);
    }

    /** Creates a timer whose thread has that name. */
    public Timer(String name, boolean isDaemon) {
        Thread thread = new Thread(this::work, Objects.requireNonNull(name));
        thread.setDaemon(isDaemon);
        thread.start();
    }

    /** Runs the task once, {@code delay} milliseconds from now. */
    public void schedule(TimerTask task, long delay) {
        add(task, afterDelay(delay), 0);
    }

    /** Runs the task once at that time, at once if it has passed. */
    public void schedule(TimerTask task, Date time) {
        add(task, time.getTime(), 0);
    }

    /**
     * Runs the task {@code delay} milliseconds from now, then each time {@code period} milliseconds after the start of
     * the last run.
     */
    public void schedule(TimerTask task, long delay, long period) {
        add(task, afterDelay(delay), -requirePositive(period));
    }

    /** Runs the task at that time, then each time {@code period} milliseconds after the start of the last run. */
    public void schedule(TimerTask task, Date firstTime, long period) {
        add(task, firstTime.getTime(), -requirePositive(period));
    }

    /**
     * Runs the task {@code delay} milliseconds from now, then every {@code period} milliseconds; catches up when late.
     */
    public void scheduleAtFixedRate(TimerTask task, long delay, long period) {
        add(task, afterDelay(delay), requirePositive(period));
    }

    /** Runs the task at that time, then every {@code period} milliseconds; catches up when late. */
    public void scheduleAtFixedRate(TimerTask task, Date firstTime, long period) {
        add(task, firstTime.getTime(), requirePositive(period));
    }

    private static long afterDelay(long delay) {
        if (delay < 0) {
            throw new IllegalArgumentException("Negative delay.");
        }
        return System.currentTimeMillis() + delay;
    }

    private static long requirePositive(long period) {
        if (period <= 0) {
            throw new IllegalArgumentException("Non-positive period.");
        }
        return period;
    }

    private void add(TimerTask task, long due, long period) {
        if (due < 0) {
            throw new IllegalArgumentException("Illegal execution time.");
        }
        synchronized (monitor) {
            if (cancelled) {
                throw new IllegalStateException("Timer already cancelled.");
            }
            task.schedule(due, period);
            enqueue(task);
            monitor.notifyAll();
        }
    }

    /** Behind every task that is due at the same time. */
    private void enqueue(TimerTask task) {
        int place = tasks.size();
        while (place > 0 && tasks.get(place - 1).due() > task.due()) {
            place--;
        }
        tasks.add(place, task);
    }

    /** Ends the timer: no further task is run; one that is running completes. */
    public void cancel() {
        synchronized (monitor) {
            cancelled = true;
            tasks.clear();
            monitor.notifyAll();
        }
    }

    /** Forgets cancelled tasks and returns their number. */
    public int purge() {
        synchronized (monitor) {
            int before = tasks.size();
            tasks.removeIf(TimerTask::cancelled);
            return before - tasks.size();
        }
    }

    private void work() {
        try {
            TimerTask task;
            while ((task = next()) != null) {
                task.run();
            }
        } finally {
            // A task that throws ends its timer.
            cancel();
        }
    }

    /** Waits for the next run of a task; null if the timer was cancelled. */
    private TimerTask next() {
        synchronized (monitor) {
            while (!cancelled) {
                TimerTask task = tasks.isEmpty() ? null : tasks.get(0);
                if (task != null && task.cancelled()) {
                    tasks.remove(0);
                    continue;
                }
                long now = System.currentTimeMillis();
                if (task != null && task.due() <= now) {
                    tasks.remove(0);
                    if (task.advance(now)) {
                        enqueue(task);
                    }
                    return task;
                }
                await(task == null ? Deadline.NEVER : Deadline.after(task.due() - now, TimeUnit.MILLISECONDS));
            }
            return null;
        }
    }

    private void await(Deadline deadline) {
        try {
            deadline.await(monitor);
        } catch (InterruptedException e) {
            // Nobody but a task can interrupt this thread; the next task must not inherit that.
            Thread.interrupted();
        }
    }
}
