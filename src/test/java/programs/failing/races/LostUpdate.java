package programs.failing.races;

/**
 * A counter without a lock: some random schedules lose an update.
 *
 * @expected exited 0
 * @explore 300 exited 1
 */
public class LostUpdate {
    private static int counter;

    public static void main(String[] args) throws InterruptedException {
        Thread other = new Thread(LostUpdate::count);
        other.start();
        count();
        other.join();
        System.exit(counter == 4000 ? 0 : 1);
    }

    private static void count() {
        for (int i = 0; i < 2000; i++) {
            counter = add(counter);
        }
    }

    private static int add(int value) {
        int sum = value;
        for (int i = 0; i < 2; i++) {
            sum += i;
        }
        return sum;
    }
}
