package programs.passing.threads;

/**
 * Two threads take turns with wait and notify.
 *
 * @expected exited 0
 * @prints ping 0
 * @prints pong 0
 * @prints ping 1
 * @prints pong 1
 * @prints done at 600 ms in main
 */
public class PingPong {
    private final Object lock = new Object();
    private boolean ping = true;

    void play(String word, boolean mine) {
        for (int i = 0; i < 2; i++) {
            synchronized (lock) {
                while (ping != mine) {
                    try {
                        lock.wait();
                    } catch (InterruptedException e) {
                        return;
                    }
                }
                System.out.println(word + " " + i);
                ping = !mine;
                lock.notifyAll();
            }
            try {
                Thread.sleep(300);
            } catch (InterruptedException e) {
                return;
            }
        }
    }

    public static void main(String[] args) throws InterruptedException {
        PingPong game = new PingPong();
        long start = System.currentTimeMillis();
        Thread other = new Thread(() -> game.play("pong", false));
        other.start();
        game.play("ping", true);
        other.join();
        long millis = System.currentTimeMillis() - start;
        System.out.println("done at " + millis / 100 * 100 + " ms in " + Thread.currentThread().getName());
    }
}
