package brickless.kernel.hooks;

/**
 * What rewritten bytecode charges by itself, in virtual nanoseconds: estimates for the EV3's 300 MHz ARM9 running an
 * embedded JVM.
 *
 * <p>Assumptions, not measurements; the charges of API calls are in the kernel's own table.
 */
public final class InstructionCharges {
    /** One round of a loop, or the entry of a lambda body. */
    public static final int BACK_EDGE_NANOS = 500;

    /**
     * One round of a loop that only reads and compares, such as {@code while (!done) {}}: dearer, so that waiting is
     * simulated quickly.
     */
    public static final int PURE_SPIN_NANOS = 20_000;

    /** One call of a method that calls others; makes endless or exponential recursion reach the time limit. */
    public static final int CALL_NANOS = 100;

    /** One byte of a new array. */
    public static final int ALLOCATION_NANOS_PER_BYTE = 4;

    /** A StackOverflowError with its trace; makes programs that catch it and recurse again reach the time limit. */
    public static final int STACK_OVERFLOW_NANOS = 1_000_000;

    /** Largest array in bytes: about the heap that the brick's JVM gives a program. Assumption. */
    public static final long LARGEST_ARRAY_BYTES = 32L << 20;

    /** Calls that may be open on one thread before StackOverflowError. Assumption. */
    public static final int LARGEST_CALL_DEPTH = 2_000;

    private InstructionCharges() {}
}
