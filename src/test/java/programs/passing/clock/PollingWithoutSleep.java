package programs.passing.clock;

/**
 * A loop that only polls the clock makes progress, because reading it takes time.
 *
 * @expected exited 0
 * @prints one second over, polls plausible true
 */
public class PollingWithoutSleep {
    public static void main(String[] args) {
        long end = System.currentTimeMillis() + 1000;
        int polls = 0;
        while (System.currentTimeMillis() < end) {
            polls++;
        }
        System.out.println("one second over, polls plausible " + (polls > 100_000 && polls < 1_000_000));
    }
}
