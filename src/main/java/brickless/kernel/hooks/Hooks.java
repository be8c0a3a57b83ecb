package brickless.kernel.hooks;

import java.util.function.Consumer;

/**
 * The hooks that rewritten loops, calls, allocations and handlers use, and the robot's link to its kernel.
 *
 * <p>Every robot's class loader defines this class anew; where robots share a loader, its static fields are those of
 * the robot that has the processor. Until {@link #bind} a {@link HostMachine} stands in for the kernel: rewritten
 * classes then behave like plain ones. With a kernel only the running fibre touches these fields; fibres hand over with
 * a happens-before edge, so they need not be volatile.
 */
public final class Hooks {
    /** Virtual nanoseconds left before the kernel must be entered. */
    public static int left;

    /** Open calls of the running fibre. */
    public static int depth;

    private static RobotState robot = new RobotState(null);
    private static VirtualMachine machine = robot.machine;
    private static int largestDepth = robot.largestDepth;
    private static long largestArrayBytes = robot.largestArrayBytes;
    /** Told of each class whose initialisation begins; the same for all robots. */
    private static Consumer<Class<?>> classListener = type -> { };

    private Hooks() {}

    /**
     * Connects this robot to its kernel before the program's first instruction; null returns to plain JDK behaviour.
     *
     * @return the robot's counters, which are a {@link StaticState} too
     */
    public static Budget bind(VirtualMachine kernel) {
        if (kernel == null) {
            robot.forget();
        }
        left = 0;
        depth = 0;
        use(new RobotState(kernel));
        return robot;
    }

    /** Says who is told of each class whose initialisation begins, for whatever robot. */
    public static void listen(Consumer<Class<?>> listener) {
        classListener = listener;
    }

    static void use(RobotState state) {
        robot = state;
        machine = state.machine;
        largestDepth = state.largestDepth;
        largestArrayBytes = state.largestArrayBytes;
    }

    /** What the hooks keep for the robot that has the processor. */
    static RobotState robot() {
        return robot;
    }

    static void initialisationBegins(Class<?> type) {
        classListener.accept(type);
    }

    /** The machine that this robot's program runs on. */
    static VirtualMachine machine() {
        return machine;
    }

    /** Whether a kernel is bound. */
    static boolean isBound() {
        return !(machine instanceof HostMachine);
    }

    /** A loop goes round, or a lambda body begins. May switch fibres. */
    public static void tick() {
        if ((left -= InstructionCharges.BACK_EDGE_NANOS) < 0) {
            machine.budgetExhausted();
        }
    }

    /** A loop that only reads and compares goes round. May switch fibres. */
    public static void spin() {
        if ((left -= InstructionCharges.PURE_SPIN_NANOS) < 0) {
            machine.budgetExhausted();
        }
    }

    /**
     * A method that calls others begins. May switch fibres.
     *
     * @return the depth to restore in the method's handlers; one less at its returns
     * @throws StackOverflowError beyond {@link InstructionCharges#LARGEST_CALL_DEPTH}
     */
    public static int enter() {
        int entered = depth + 1;
        if (entered > largestDepth) {
            machine.charge(InstructionCharges.STACK_OVERFLOW_NANOS);
            throw new StackOverflowError();
        }
        depth = entered;
        if ((left -= InstructionCharges.CALL_NANOS) < 0) {
            machine.budgetExhausted();
        }
        return entered;
    }

    /**
     * An exception handler that could swallow anything begins: lets {@link ProgramKilled} pass while the program is
     * being ended.
     */
    public static void kill(Throwable caught) {
        if (caught instanceof ProgramKilled && machine.killing()) {
            throw (ProgramKilled) caught;
        }
    }

    /**
     * An array is about to be created. May switch fibres.
     *
     * @param length elements; negative ones are left to the JVM to refuse
     * @param elementBytes bytes of one element
     * @throws OutOfMemoryError if the brick could not hold the array
     */
    public static void allocate(int length, int elementBytes) {
        if (length > 0) {
            allocateBytes((long) length * elementBytes);
        }
    }

    /** A two-dimensional array is about to be created; see {@link #allocate}. */
    public static void allocate(int rows, int columns, int elementBytes) {
        if (rows > 0 && columns > 0) {
            allocateBytes((long) rows * columns * elementBytes);
        }
    }

    private static void allocateBytes(long bytes) {
        if (bytes > largestArrayBytes) {
            throw new OutOfMemoryError("Java heap space");
        }
        long nanos = bytes * InstructionCharges.ALLOCATION_NANOS_PER_BYTE;
        if (nanos <= left) {
            left -= (int) nanos;
        } else {
            machine.charge(nanos);
        }
    }
}
