package brickless.kernel;

import brickless.kernel.hooks.ProgramKilled;

/**
 * Who hears of an exception that ended a thread: the thread's handler, else the program's default handler, else the
 * run, which fails.
 */
final class UncaughtExceptions {
    private final Ending ending;
    private KernelListener listener = new KernelListener() { };
    private Thread.UncaughtExceptionHandler defaultHandler;

    UncaughtExceptions(Ending ending) {
        this.ending = ending;
    }

    void listen(KernelListener newListener) {
        listener = newListener;
    }

    Thread.UncaughtExceptionHandler defaultHandler() {
        return defaultHandler;
    }

    void defaultHandler(Thread.UncaughtExceptionHandler handler) {
        defaultHandler = handler;
    }

    /** Runs on the thread that threw. */
    void thrown(Thread thread, Throwable failure) {
        try {
            Thread.UncaughtExceptionHandler handler = handlerOf(thread);
            if (handler != null) {
                callHandler(handler, thread, failure);
            } else if (!(failure instanceof ThreadDeath)) {
                ending.uncaught(failure);
                listener.uncaught(thread, failure);
            }
        } catch (ProgramKilled e) {
            // The program was ended meanwhile, which is what this thread does now anyway.
            return;
        }
    }

    /** The JVM ignores what a handler throws; so do we, except for the end of the program. */
    private static void callHandler(Thread.UncaughtExceptionHandler handler, Thread thread, Throwable failure) {
        try {
            handler.uncaughtException(thread, failure);
        } catch (ProgramKilled e) {
            throw e;
        } catch (Throwable ignoredAsByTheJvm) {
            return;
        }
    }

    /** The host's thread groups are no handlers: they would ask the host's default handler. */
    private Thread.UncaughtExceptionHandler handlerOf(Thread thread) {
        Thread.UncaughtExceptionHandler own = thread.getUncaughtExceptionHandler();
        return own == null || own.getClass() == ThreadGroup.class ? defaultHandler : own;
    }
}
