package brickless.kernel.hooks;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.IdentityHashMap;
import java.util.Map;

/**
 * Class initialisation on fibres (JLS 12.4.2). A static initialiser that may block is renamed by the loader and run
 * from here, so that it is an ordinary Java frame that can be switched away. Per robot.
 */
public final class ClassInitialization {
    /** Renamed {@code <clinit>}. */
    public static final String INITIALISER = "$clinit$";
    /** Static method that makes sure that its class is initialised; the loader calls it before each active use. */
    public static final String TRIGGER = "$init";

    private static final MethodHandles.Lookup LOOKUP = MethodHandles.lookup();
    private static final MethodType NO_ARGUMENTS = MethodType.methodType(void.class);
    private static final Map<Class<?>, Progress> STARTED = new IdentityHashMap<>();

    private ClassInitialization() {}

    /**
     * Initialises a class unless that has happened or the calling thread is at it; blocks while another thread is.
     *
     * @param ownInitialiser whether the class has a renamed initialiser; if not, only its superclasses have work to do
     * @return whether it is complete, so that the trigger need not call again
     */
    public static boolean initialize(Class<?> type, boolean ownInitialiser) {
        Thread self = Hooks.machine().currentThread();
        Progress progress = progressOf(type);
        MonitorHooks.enter(progress);
        try {
            awaitOthers(progress, self);
            if (progress.complete || progress.initializer == self) {
                return progress.complete;
            }
            if (progress.failed) {
                throw new NoClassDefFoundError("Could not initialize class " + type.getName());
            }
            progress.initializer = self;
        } finally {
            MonitorHooks.exit(progress);
        }
        run(type, ownInitialiser, progress);
        return true;
    }

    /**
     * Initialises a class that is about to be used by reflection, and its superclasses; does nothing for other classes.
     */
    public static void initializeForReflection(Class<?> type) {
        if (type.getClassLoader() == ClassInitialization.class.getClassLoader() && !type.isInterface()) {
            callIfPresent(type, TRIGGER);
        }
    }

    private static synchronized Progress progressOf(Class<?> type) {
        return STARTED.computeIfAbsent(type, key -> new Progress());
    }

    private static void run(Class<?> type, boolean ownInitialiser, Progress progress) {
        try {
            initializeForReflection(type.getSuperclass());
            if (ownInitialiser) {
                callIfPresent(type, INITIALISER);
            }
        } catch (ProgramKilled killed) {
            throw killed;
        } catch (Throwable failure) {
            finish(progress, true);
            throw failure instanceof Error ? (Error) failure : new ExceptionInInitializerError(failure);
        }
        finish(progress, false);
    }

    private static void finish(Progress progress, boolean failed) {
        MonitorHooks.enter(progress);
        try {
            progress.complete = !failed;
            progress.failed = failed;
            progress.initializer = null;
            MonitorHooks.notifyAll(progress);
        } finally {
            MonitorHooks.exit(progress);
        }
    }

    private static void callIfPresent(Class<?> type, String method) {
        MethodHandle handle;
        try {
            handle = MethodHandles.privateLookupIn(type, LOOKUP).findStatic(type, method, NO_ARGUMENTS);
        } catch (NoSuchMethodException absent) {
            return;
        } catch (IllegalAccessException broken) {
            throw new LinkageError(type.getName(), broken);
        }
        try {
            handle.invokeExact();
        } catch (Throwable failure) {
            throw ClassInitialization.<RuntimeException>unchecked(failure);
        }
    }

    /** Throws any exception as it is: an initialiser's exceptions must not be wrapped twice. */
    @SuppressWarnings("unchecked")
    private static <E extends Throwable> E unchecked(Throwable failure) throws E {
        throw (E) failure;
    }

    private static void awaitOthers(Progress progress, Thread self) {
        boolean interrupted = false;
        while (progress.initializer != null && progress.initializer != self) {
            try {
                MonitorHooks.wait(progress);
            } catch (InterruptedException kept) {
                interrupted = true;
            }
        }
        if (interrupted) {
            ThreadHooks.interrupt(self);
        }
    }

    /** Guarded by its own virtual monitor. */
    private static final class Progress {
        private Thread initializer;
        private boolean complete;
        private boolean failed;
    }
}
