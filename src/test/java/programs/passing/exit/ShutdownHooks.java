package programs.passing.exit;

/**
 * Shutdown hooks run when the program ends; a removed one does not; they may sleep and print.
 *
 * @expected exited 0
 * @prints main ends
 * @prints hook slept
 */
public class ShutdownHooks {
    public static void main(String[] args) {
        Thread removed = new Thread(() -> System.out.println("removed"));
        Runtime.getRuntime().addShutdownHook(removed);
        Runtime.getRuntime().addShutdownHook(new Thread(() -> {
            try {
                Thread.sleep(100);
            } catch (InterruptedException e) {
                return;
            }
            System.out.println("hook slept");
        }));
        System.out.println(Runtime.getRuntime().removeShutdownHook(removed) ? "main ends" : "not removed");
    }
}
