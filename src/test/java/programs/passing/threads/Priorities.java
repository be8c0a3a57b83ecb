package programs.passing.threads;

/**
 * Priorities are kept, inherited and checked, and change nothing.
 *
 * @expected exited 0
 * @prints 5 10 10
 * @prints 0 is refused
 * @prints low priority ran too
 */
public class Priorities {
    public static void main(String[] args) throws InterruptedException {
        int normal = Thread.currentThread().getPriority();
        Thread.currentThread().setPriority(Thread.MAX_PRIORITY);
        Thread low = new Thread(() -> System.out.println("low priority ran too"));
        System.out.println(normal + " " + Thread.currentThread().getPriority() + " " + low.getPriority());
        try {
            low.setPriority(0);
        } catch (IllegalArgumentException e) {
            System.out.println("0 is refused");
        }
        low.setPriority(Thread.MIN_PRIORITY);
        low.start();
        long end = System.currentTimeMillis() + 200;
        while (System.currentTimeMillis() < end) {
            Thread.yield();
        }
        low.join();
    }
}
