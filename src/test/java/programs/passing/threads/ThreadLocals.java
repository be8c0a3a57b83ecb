package programs.passing.threads;

/**
 * Thread locals belong to the program's threads; inheritable ones are copied when a thread is created.
 *
 * @expected exited 0
 * @prints main: 0 a
 * @prints main: 1 b
 * @prints child: 0 b, supplied 7
 * @prints main: 0 b
 */
public class ThreadLocals {
    private static final ThreadLocal<Integer> COUNT = new ThreadLocal<Integer>() {
        @Override
        protected Integer initialValue() {
            return 0;
        }
    };
    private static final InheritableThreadLocal<String> NAME = new InheritableThreadLocal<>();
    private static final ThreadLocal<Integer> SUPPLIED = ThreadLocal.withInitial(() -> 7);

    public static void main(String[] args) throws InterruptedException {
        NAME.set("a");
        System.out.println("main: " + COUNT.get() + " " + NAME.get());
        COUNT.set(1);
        NAME.set("b");
        System.out.println("main: " + COUNT.get() + " " + NAME.get());
        Thread child = new Thread(() -> {
            System.out.println("child: " + COUNT.get() + " " + NAME.get() + ", supplied " + SUPPLIED.get());
            NAME.set("c");
        });
        child.start();
        child.join();
        COUNT.remove();
        System.out.println("main: " + COUNT.get() + " " + NAME.get());
    }
}
