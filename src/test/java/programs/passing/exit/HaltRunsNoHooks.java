package programs.passing.exit;

/**
 * Runtime.halt ends the program without its shutdown hooks.
 *
 * @expected exited 7
 * @prints halting
 */
public class HaltRunsNoHooks {
    public static void main(String[] args) {
        Runtime.getRuntime().addShutdownHook(new Thread(() -> System.out.println("hook")));
        System.out.println("halting");
        Runtime.getRuntime().halt(7);
    }
}
