package programs.passing.threads;

/**
 * A thread that spins on a plain field without a call sees another thread's write.
 *
 * @expected exited 0
 * @prints seen after 300 ms
 */
public class SpinUntilFlag {
    private boolean done;

    public static void main(String[] args) {
        SpinUntilFlag program = new SpinUntilFlag();
        long start = System.currentTimeMillis();
        new Thread(() -> {
            try {
                Thread.sleep(300);
            } catch (InterruptedException e) {
                return;
            }
            program.done = true;
        }).start();
        while (!program.done) {
        }
        System.out.println("seen after " + (System.currentTimeMillis() - start) / 100 * 100 + " ms");
    }
}
