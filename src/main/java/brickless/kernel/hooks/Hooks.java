package brickless.kernel.hooks;

/**
 * The hooks that rewritten loops, calls, allocations and handlers use, and the robot's link to its kernel.
 *
 * <p>Every robot's class loader defines this class anew, so its static fields are per robot. Until {@link #bind} a
 * {@link HostMachine} stands in for the kernel: rewritten classes then behave like plain ones. With a kernel only the
 * running fibre touches these fields; fibres hand over with a happens-before edge, so they need not be volatile.
 */
public final class Hooks {
    /** Virtual nanoseconds left before the kernel must be entered. */
    public static int left;

    /** Open calls of the running fibre. */
    public static int depth;

    private static int largestDepth = Integer.MAX_VALUE;
    private static long largestArrayBytes = Long.MAX_VALUE;
    private static VirtualMachine machine = new HostMachine();

    private Hooks() {}

    /**
     * Connects this robot to its kernel before the program's first instruction; null returns to plain JDK behaviour.
     */
    public static Budget bind(VirtualMachine kernel) {
        machine = kernel == null ? new HostMachine() : kernel;
        largestDepth = kernel == null ? Integer.MAX_VALUE : InstructionCharges.LARGEST_CALL_DEPTH;
        largestArrayBytes = kernel == null ? Long.MAX_VALUE : InstructionCharges.LARGEST_ARRAY_BYTES;
        left = 0;
        depth = 0;
        return new StaticBudget();
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

    /** The kernel's access to {@link #left} and {@link #depth}. */
    private static final class StaticBudget implements Budget {
        @Override
        public int left() {
            return left;
        }

        @Override
        public void grant(int nanos) {
            left = nanos;
        }

        @Override
        public int depth() {
            return depth;
        }

        @Override
        public void depth(int restored) {
            depth = restored;
        }
    }
}
