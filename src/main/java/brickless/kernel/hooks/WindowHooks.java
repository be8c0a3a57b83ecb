package brickless.kernel.hooks;

import java.awt.HeadlessException;

/** Windows of rewritten code: a brick has none, and the JDK's event thread is outside of virtual time. */
public final class WindowHooks {
    private WindowHooks() {}

    /**
     * {@code EventQueue.invokeLater(task)} and its like.
     *
     * @throws HeadlessException always, as opening a window does
     */
    public static void invoke(Runnable task) {
        throw new HeadlessException();
    }
}
