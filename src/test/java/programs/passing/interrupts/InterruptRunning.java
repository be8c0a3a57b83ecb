package programs.passing.interrupts;

/**
 * Interrupting a running thread only sets its flag; Thread.interrupted reads and clears it.
 *
 * @expected exited 0
 * @prints flag seen
 * @prints true then false
 */
public class InterruptRunning {
    public static void main(String[] args) throws InterruptedException {
        Thread runner = new Thread(() -> {
            while (!Thread.currentThread().isInterrupted()) {
                Math.sqrt(2);
            }
            System.out.println("flag seen");
            boolean first = Thread.interrupted();
            System.out.println(first + " then " + Thread.interrupted());
        });
        runner.start();
        Thread.sleep(20);
        runner.interrupt();
        runner.join();
    }
}
