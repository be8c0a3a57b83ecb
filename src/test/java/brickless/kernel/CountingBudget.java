package brickless.kernel;

import brickless.kernel.hooks.Budget;

/** The counters that rewritten code would keep in static fields. */
public final class CountingBudget implements Budget {
    private int left;
    private int depth;

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
    public void depth(int newDepth) {
        depth = newDepth;
    }

    /** What a back-edge does. */
    void tick(Kernel kernel) {
        left -= Costs.BACK_EDGE_NANOS;
        if (left < 0) {
            kernel.budgetExhausted();
        }
    }
}
