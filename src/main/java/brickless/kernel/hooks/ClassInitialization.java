package brickless.kernel.hooks;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodType;
import java.lang.reflect.Field;

/**
 * Class initialisation of rewritten classes (JLS 12.4.2). The loader renames each static initialiser and calls a
 * trigger before each use of the class in other classes; here is decided who runs the initialiser and who waits. The
 * JVM's own initialisation would happen once for all robots that share the classes, and would make a second thread wait
 * on the host. Per robot.
 *
 * <p>Who runs an initialiser that may block holds a virtual monitor meanwhile, so that a deadlock is found like any
 * other. One that only computes costs nothing but what it does: its thread keeps the processor until it ends.
 */
public final class ClassInitialization {
    /** Renamed {@code <clinit>}. */
    public static final String INITIALISER = "$clinit$";
    /** Static method that makes sure that its class is initialised; the loader calls it before each active use. */
    public static final String TRIGGER = "$init";
    /** What the trigger calls unless the class is initialised. */
    public static final String SLOW_TRIGGER = "$initialize";
    /**
     * Ends the name of the class that holds the computed constants of an interface, with their initialiser: only the
     * JVM itself could set them in the interface.
     */
    public static final String STATICS_SUFFIX = "$$Statics";

    private static final MethodType NO_ARGUMENTS = MethodType.methodType(void.class);

    private ClassInitialization() {}

    /**
     * Begins to initialise a class unless that has happened or the calling thread is at it; blocks while another thread
     * is.
     *
     * @param mayBlock whether its initialiser, or one that must run before, may block
     * @return whether the caller must now initialise it, and say {@link #complete} or {@link #failed}
     * @throws NoClassDefFoundError if that was tried before and failed
     */
    public static boolean begin(Class<?> type, boolean mayBlock) {
        Progress progress = progressOf(type);
        progress.mayBlock = mayBlock || !Hooks.isBound();
        progress.enter();
        if (progress.failed || progress.begun) {
            progress.exit();
            if (progress.failed) {
                throw new NoClassDefFoundError("Could not initialize class " + progress.name());
            }
            return false;
        }
        progress.begun = true;
        Hooks.initialisationBegins(type);
        return true;
    }

    /** The class is initialised. */
    public static void complete(Class<?> type) {
        end(progressOf(type), false);
    }

    /**
     * The initialisation of a class failed.
     *
     * @return what to throw
     */
    public static Error failed(Throwable failure, Class<?> type) {
        Progress progress = progressOf(type);
        if (failure instanceof ProgramKilled) {
            progress.exit();
            return (ProgramKilled) failure;
        }
        end(progress, true);
        return failure instanceof Error ? (Error) failure : new ExceptionInInitializerError(failure);
    }

    /**
     * Initialises a class that is about to be used by reflection, and its superclasses; does nothing for other classes.
     */
    public static void initializeForReflection(Class<?> type) {
        if (isRewritten(type)) {
            Class<?> statics = type.isInterface() ? staticsOf(type) : type;
            if (statics != null) {
                callTrigger(statics);
            }
        }
    }

    /** Where the value of a static field is: computed constants of an interface are not in the interface. */
    static Field storage(Field field) {
        Class<?> statics = field.getDeclaringClass().isInterface() && isRewritten(field.getDeclaringClass())
                ? staticsOf(field.getDeclaringClass()) : null;
        try {
            return statics == null ? field : statics.getField(field.getName());
        } catch (NoSuchFieldException constant) {
            return field;
        }
    }

    private static boolean isRewritten(Class<?> type) {
        return !type.isArray() && type.getClassLoader() == ClassInitialization.class.getClassLoader();
    }

    private static Class<?> staticsOf(Class<?> type) {
        try {
            return Class.forName(type.getName() + STATICS_SUFFIX, false, type.getClassLoader());
        } catch (ClassNotFoundException none) {
            return null;
        }
    }

    private static synchronized Progress progressOf(Class<?> type) {
        return Hooks.robot().initialisations.computeIfAbsent(type, Progress::new);
    }

    /** Costs a monitor's entry again, as the JVM takes the class's lock once more to say that it is done. */
    private static void end(Progress progress, boolean failed) {
        try {
            if (progress.mayBlock) {
                MonitorHooks.enter(progress);
                MonitorHooks.exit(progress);
            }
            progress.failed = failed;
        } finally {
            progress.exit();
        }
    }

    private static void callTrigger(Class<?> type) {
        MethodHandle trigger;
        try {
            trigger = ReflectionHooks.insideOf(type).findStatic(type, TRIGGER, NO_ARGUMENTS);
        } catch (NoSuchMethodException absent) {
            return;
        } catch (IllegalAccessException broken) {
            throw new LinkageError(type.getName(), broken);
        }
        try {
            trigger.invokeExact();
        } catch (Throwable failure) {
            throw ReflectionHooks.<RuntimeException>unchecked(failure);
        }
    }

    /**
     * How far the initialisation of one class is. If it may block, guarded by its own virtual monitor, which the
     * initialising thread holds; if not, by the processor, which that thread keeps.
     */
    static final class Progress implements NamedMonitor {
        private final Class<?> type;
        private boolean mayBlock;
        private boolean begun;
        private boolean failed;

        Progress(Class<?> type) {
            this.type = type;
        }

        void enter() {
            if (mayBlock) {
                MonitorHooks.enter(this);
            } else {
                Hooks.machine().undivided(true);
            }
        }

        void exit() {
            if (mayBlock) {
                MonitorHooks.exit(this);
            } else {
                Hooks.machine().undivided(false);
            }
        }

        String name() {
            String name = type.getName();
            return name.endsWith(STATICS_SUFFIX) ? name.substring(0, name.length() - STATICS_SUFFIX.length()) : name;
        }

        @Override
        public String monitorName() {
            return "the initialisation of " + name();
        }
    }
}
