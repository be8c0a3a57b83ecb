package programs.passing.exit;

/**
 * Shutdown hooks run in the order in which they were added; one that exits ends only itself.
 *
 * @expected exited 0
 * @prints main ends
 * @prints first
 * @prints second exits
 * @prints third
 */
public class HooksInOrder {
    public static void main(String[] args) {
        addHook(() -> System.out.println("first"));
        addHook(() -> {
            System.out.println("second exits");
            System.exit(3);
            System.out.println("not reached");
        });
        addHook(() -> System.out.println("third"));
        System.out.println("main ends");
    }

    private static void addHook(Runnable hook) {
        Runtime.getRuntime().addShutdownHook(new Thread(hook));
    }
}
