package programs.passing.exit;

/**
 * The program ends when its last thread ends, long after main.
 *
 * @expected exited 0
 * @prints main ends
 * @prints 3000 ms later
 */
public class LastThreadEnds {
    public static void main(String[] args) {
        long begin = System.currentTimeMillis();
        new Thread(() -> {
            try {
                Thread.sleep(3_000);
            } catch (InterruptedException e) {
                return;
            }
            System.out.println((System.currentTimeMillis() - begin) / 100 * 100 + " ms later");
        }).start();
        System.out.println("main ends");
    }
}
