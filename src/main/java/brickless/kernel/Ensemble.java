package brickless.kernel;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Several kernels, one for each robot of a world, that meet at the physics steps.
 *
 * <p>Between two steps each kernel runs its own share, in the order of the list; when all have reached the boundary
 * the step handler is called once. A kernel whose program ended drops out. Events of a kernel run in its share: what
 * concerns the whole world belongs into the step handler. All kernels share the first kernel's back-end and watchdog
 * settings and must have the same step length.
 *
 * <p>All of this happens on the stack of whichever fibre gave its processor up last.
 */
public final class Ensemble {
    private final List<Kernel> kernels;
    private final StepHandler stepHandler;
    private final Heartbeat heartbeat = new Heartbeat();
    private final long stepNanos;
    private Backend backend;
    /** Whose share runs; written by the running fibre, and opaque, because the watchdog reads it. */
    private final AtomicInteger running = new AtomicInteger();
    private long boundaryNanos;

    /**
     * Creates an ensemble.
     *
     * @param kernels in the order in which they run their shares; at least one
     * @param stepHandler called at each multiple of the step length; null for no physics
     */
    public Ensemble(List<Kernel> kernels, StepHandler stepHandler) {
        this.kernels = List.copyOf(kernels);
        this.stepHandler = stepHandler;
        if (kernels.stream().mapToLong(kernel -> kernel.settings().stepNanos()).distinct().count() != 1) {
            throw new IllegalArgumentException(
                    "an ensemble needs at least one kernel, and all with the same step length");
        }
        stepNanos = kernels.get(0).settings().stepNanos();
    }

    /**
     * Runs all programs to their ends and waits for them. An ensemble runs once.
     *
     * @return how each program ended, in the order of the kernels
     * @throws CancellationException if the calling thread is interrupted: the programs are then ended and the
     *     interrupt flag kept
     */
    public List<ProgramEnd> run() {
        KernelSettings settings = kernels.get(0).settings();
        backend = settings.backend().open(settings.stackBytes());
        kernels.forEach(kernel -> kernel.prepare(this::next, stepHandler != null, backend, heartbeat));
        Watchdog watchdog = Watchdog.watch(heartbeat, settings.watchdogNanos(), this::hostThread, this::abandonRunaway);
        try {
            backend.start(kernels.get(0).proceed(), this::failed);
            awaitEnd();
            return results();
        } finally {
            watchdog.stop();
            kernels.forEach(Kernel::release);
        }
    }

    /**
     * The kernel whose share runs is done with it: the others have theirs, until a fibre is to run. Robots without one
     * need none of their stacks for that.
     */
    private Fibre next() {
        while (true) {
            Kernel kernel = following();
            Fibre fibre = kernel == null ? null : kernel.proceed();
            if (kernel == null || fibre != null) {
                return fibre;
            }
        }
    }

    /** Whose share comes next; after the last one's the world steps. Null if all programs are over. */
    private Kernel following() {
        int index = firstLive(running.getPlain() + 1);
        if (index < 0) {
            index = firstLive(0);
            if (index < 0) {
                return null;
            }
            boundaryNanos += stepNanos;
            step(boundaryNanos);
        }
        running.setOpaque(index);
        return kernels.get(index);
    }

    private int firstLive(int from) {
        for (int i = from; i < kernels.size(); i++) {
            if (!kernels.get(i).over()) {
                return i;
            }
        }
        return -1;
    }

    /** What the handler throws ends all programs. */
    private void step(long timeNanos) {
        heartbeat.hostBegins();
        try {
            stepHandler.step(timeNanos);
        } catch (RuntimeException | Error e) {
            kernels.forEach(kernel -> kernel.ending().hostFailed(e, timeNanos));
        } finally {
            heartbeat.hostEnds();
        }
    }

    private void awaitEnd() {
        try {
            backend.awaitEnd();
        } catch (InterruptedException e) {
            kernels.forEach(kernel -> kernel.ending().kill(ProgramEnd.Kind.TIME_LIMIT, kernel.nowNanos(), 0, ""));
            awaitUninterruptibly();
            Thread.currentThread().interrupt();
            throw new CancellationException("the run was interrupted");
        }
    }

    private void awaitUninterruptibly() {
        boolean waiting = true;
        while (waiting) {
            try {
                backend.awaitEnd();
                waiting = false;
            } catch (InterruptedException again) {
                waiting = true;
            }
        }
    }

    private List<ProgramEnd> results() {
        List<ProgramEnd> ends = new ArrayList<>();
        for (Kernel kernel : kernels) {
            Throwable failure = kernel.ending().hostFailure();
            if (failure instanceof Error error) {
                throw error;
            }
            if (failure != null) {
                throw failure instanceof RuntimeException exception ? exception : new IllegalStateException(failure);
            }
            ends.add(Objects.requireNonNull(kernel.end(), "a program is over without an end"));
        }
        return ends;
    }

    /** From the watchdog's thread. */
    private Thread hostThread() {
        Fibre fibre = kernels.get(running.getOpaque()).currentFibre();
        return fibre == null ? null : backend.hostThreadOf(fibre);
    }

    /** From the watchdog's thread. */
    private void abandonRunaway() {
        Kernel runaway = kernels.get(running.getOpaque());
        String dump = runaway.dump("runaway");
        runaway.ending().abandon(runaway.nowNanos(), dump);
        abandonAll("ended because " + runaway.settings().name() + " is a runaway\n");
    }

    /** From a carrier whose fibre broke the kernel, or that the host could not start. */
    private void failed(Throwable failure) {
        kernels.forEach(kernel -> kernel.ending().hostFailed(failure, kernel.nowNanos()));
        abandonAll("");
    }

    private void abandonAll(String reason) {
        kernels.forEach(kernel -> kernel.ending().abandon(kernel.nowNanos(), reason));
        backend.abandon();
    }
}
