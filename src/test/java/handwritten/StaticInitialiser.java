package handwritten;

/** A program whose static initialiser does the work, as many leJOS programs create their hardware there. */
public final class StaticInitialiser {
    static {
        StaticAction.run();
    }

    private StaticInitialiser() {
    }
}
