package brickless.kernel.hooks;

/**
 * The kernel's access to a robot's own budget and call-depth counters, which live in static fields so that rewritten
 * code reaches them fast.
 */
public interface Budget {
    /** Nanoseconds left before the kernel must be entered; may be negative. */
    int left();

    /** Grants nanoseconds. */
    void grant(int nanos);

    /** Call depth of the running fibre. */
    int depth();

    /** Restores the call depth when another fibre is switched in. */
    void depth(int depth);
}
