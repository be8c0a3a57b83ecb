package brickless.kernel.hooks;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.IdentityHashMap;
import java.util.Map;

/**
 * Class initialisation on fibres (JLS 12.4.2). A static initialiser that may block is renamed by the loader and run
 * from here, so that it is an ordinary Java frame that can be switched away. The initialiser of an interface stays the
 * JVM's; here is decided who makes the JVM run it, and who waits. Per robot.
 *
 * <p>Who initialises a class holds a virtual monitor meanwhile, so that a deadlock is found like any other.
 */
public final class ClassInitialization {
    /** Renamed {@code <clinit>}. */
    public static final String INITIALISER = "$clinit$";
    /** Static method that makes sure that its class is initialised; the loader calls it before each active use. */
    public static final String TRIGGER = "$init";
    /** Static constant of those classes and interfaces for which {@link #initializeGuarded} is called instead. */
    public static final String GUARDED = "$guarded";

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
        Progress progress = progressOf(type);
        MonitorHooks.enter(progress);
        try {
            if (progress.failed) {
                throw new NoClassDefFoundError("Could not initialize class " + type.getName());
            }
            if (!progress.begun) {
                progress.begun = true;
                run(type, ownInitialiser, progress);
            }
            return progress.complete;
        } finally {
            MonitorHooks.exit(progress);
        }
    }

    /** Does the same for an interface, or for a class with interfaces, that the JVM must not initialise by itself. */
    public static void initializeGuarded(Class<?> type) {
        if (!progressOf(type).complete) {
            initialize(type, !type.isInterface());
        }
    }

    /**
     * Initialises a class that is about to be used by reflection, and its superclasses; does nothing for other classes.
     */
    public static void initializeForReflection(Class<?> type) {
        if (type.getClassLoader() != ClassInitialization.class.getClassLoader()) {
            return;
        }
        if (isGuarded(type)) {
            initializeGuarded(type);
        } else if (!type.isInterface()) {
            callIfPresent(type, TRIGGER);
        }
    }

    private static synchronized Progress progressOf(Class<?> type) {
        return STARTED.computeIfAbsent(type, Progress::new);
    }

    private static void run(Class<?> type, boolean ownInitialiser, Progress progress) {
        try {
            if (type.isInterface()) {
                MethodHandles.privateLookupIn(type, LOOKUP).ensureInitialized(type);
            } else {
                initializeParents(type);
                if (ownInitialiser) {
                    callIfPresent(type, INITIALISER);
                }
            }
        } catch (ProgramKilled killed) {
            throw killed;
        } catch (Throwable failure) {
            finish(progress, true);
            throw failure instanceof Error ? (Error) failure : new ExceptionInInitializerError(failure);
        }
        finish(progress, false);
    }

    /** Costs a monitor's entry again, as the JVM takes the class's lock once more to say that it is done. */
    private static void finish(Progress progress, boolean failed) {
        MonitorHooks.enter(progress);
        progress.complete = !failed;
        progress.failed = failed;
        MonitorHooks.exit(progress);
    }

    /** The superclass and, where the JVM would do that natively, the interfaces with default methods. */
    private static void initializeParents(Class<?> type) {
        initializeForReflection(type.getSuperclass());
        if (isGuarded(type)) {
            initializeInterfaces(type);
        }
    }

    private static void initializeInterfaces(Class<?> type) {
        for (Class<?> parent : type.getInterfaces()) {
            if (parent.getClassLoader() == type.getClassLoader()) {
                initializeInterfaces(parent);
                if (isGuarded(parent) && hasDefaultMethods(parent)) {
                    initializeGuarded(parent);
                }
            }
        }
    }

    private static boolean isGuarded(Class<?> type) {
        try {
            return type.getDeclaredField(GUARDED).isSynthetic();
        } catch (NoSuchFieldException usual) {
            return false;
        }
    }

    private static boolean hasDefaultMethods(Class<?> type) {
        for (Method method : type.getDeclaredMethods()) {
            if ((method.getModifiers() & (Modifier.STATIC | Modifier.ABSTRACT)) == 0) {
                return true;
            }
        }
        return false;
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

    /** Guarded by its own virtual monitor, which the initialising thread holds. */
    private static final class Progress implements NamedMonitor {
        private final Class<?> type;
        private boolean begun;
        private boolean complete;
        private boolean failed;

        Progress(Class<?> type) {
            this.type = type;
        }

        @Override
        public String monitorName() {
            return "the initialisation of " + type.getName();
        }
    }
}
