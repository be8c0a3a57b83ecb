package programs.passing.threads;

/**
 * A join with a time limit returns after it.
 *
 * @expected exited 0
 * @prints waited 200 ms, alive true, state TIMED_WAITING
 * @prints alive false, state TERMINATED
 */
public class JoinWithTimeout {
    public static void main(String[] args) throws InterruptedException {
        Thread slow = new Thread(() -> {
            try {
                Thread.sleep(1_000);
            } catch (InterruptedException e) {
                System.out.println("unexpected");
            }
        });
        slow.start();
        long start = System.currentTimeMillis();
        slow.join(200);
        long waited = System.currentTimeMillis() - start;
        System.out.println("waited " + waited + " ms, alive " + slow.isAlive() + ", state " + slow.getState());
        slow.join(0);
        System.out.println("alive " + slow.isAlive() + ", state " + slow.getState());
    }
}
