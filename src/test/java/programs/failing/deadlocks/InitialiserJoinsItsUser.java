package programs.failing.deadlocks;

/**
 * The initialiser of an interface starts a thread that needs the interface, and joins it: neither can go on.
 *
 * @expected deadlock
 * @contains "Thread-0" BLOCKED on the initialisation of programs.failing.deadlocks.InitialiserJoinsItsUser$Settings
 *         held by "main"
 * @contains "main" WAITING for the end of "Thread-0"
 */
public class InitialiserJoinsItsUser {
    interface Settings {
        int[] VALUES = Maker.make();
    }

    static final class Maker {
        static int[] make() {
            Thread user = new Thread(() -> System.out.println(Settings.VALUES[0]));
            user.start();
            try {
                user.join();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
            return new int[1];
        }
    }

    public static void main(String[] args) {
        System.out.println(Settings.VALUES[0]);
    }
}
