package programs.failing.deadlocks;

/**
 * Three threads that hold one lock each and want the next one's are a deadlock, though a fourth is busy all the time.
 *
 * @expected deadlock
 * @contains "philosopher 0" BLOCKED on java.lang.String held by "philosopher 1"
 * @contains "philosopher 2" BLOCKED on java.lang.String held by "philosopher 0"
 * @contains at programs.failing.deadlocks.BusyBystander.dine(BusyBystander.java:32)
 */
public class BusyBystander {
    private static final Object[] FORKS = {"a", "b", "c"};
    private static volatile int work;

    public static void main(String[] args) {
        for (int i = 0; i < FORKS.length; i++) {
            int seat = i;
            new Thread(() -> dine(seat), "philosopher " + seat).start();
        }
        while (true) {
            work++;
        }
    }

    private static void dine(int seat) {
        synchronized (FORKS[seat]) {
            try {
                Thread.sleep(50);
            } catch (InterruptedException e) {
                return;
            }
            synchronized (FORKS[(seat + 1) % FORKS.length]) {
                System.out.println("ate");
            }
        }
    }
}
