package brickless.hardware;

import java.util.Optional;
import java.util.ServiceLoader;

/**
 * Finds the brick that the calling program runs on.
 *
 * <p>This class is defined anew in a robot's class loader, and its static field is exchanged with the robot, so it is
 * that robot's own. Loaded by the application loader (a plain {@code java -cp} run) the first {@link #brick()} starts a
 * live simulation through {@link BrickProvider}.
 */
public final class BrickAccess {
    private static BrickHardware current;

    private BrickAccess() {}

    /**
     * The brick of this program; starts a live one when there is none.
     *
     * @throws IllegalStateException if no brick is attached and none can be started
     */
    public static synchronized BrickHardware brick() {
        if (current == null) {
            current = ServiceLoader.load(BrickProvider.class).findFirst()
                    .orElseThrow(() -> new IllegalStateException(
                            "no virtual brick: put brickless.jar on the class path or use 'brickless run'"))
                    .startLive();
        }
        return current;
    }

    /** The brick of this program if one is attached already; never starts one. */
    public static synchronized Optional<BrickHardware> present() {
        return Optional.ofNullable(current);
    }

    /** Attaches the brick before the program's first instruction; {@code null} detaches it. */
    public static synchronized void attach(BrickHardware brick) {
        current = brick;
    }
}
