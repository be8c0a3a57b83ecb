package programs.passing.threads;

/**
 * The program ends with its last thread that is no daemon.
 *
 * @expected exited 0
 * @prints working true
 * @prints main ends
 */
public class DaemonsDoNotKeepTheProgramAlive {
    public static void main(String[] args) throws InterruptedException {
        Thread daemon = new Thread(() -> {
            System.out.println("working " + Thread.currentThread().isDaemon());
            while (true) {
                Thread.yield();
            }
        });
        daemon.setDaemon(true);
        daemon.start();
        Thread.sleep(50);
        System.out.println("main ends");
    }
}
