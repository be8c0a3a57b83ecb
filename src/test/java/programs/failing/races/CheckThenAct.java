package programs.failing.races;

import java.util.Vector;

/**
 * Every call of a Vector is atomic, two calls in a row are not: some random schedules remove from an empty one.
 *
 * @expected exited 0
 * @explore 300 failed java.lang.ArrayIndexOutOfBoundsException
 */
public class CheckThenAct {
    private static final Vector<Integer> JOBS = new Vector<>();

    public static void main(String[] args) {
        for (int i = 0; i < 50; i++) {
            JOBS.add(i);
        }
        new Thread(CheckThenAct::work).start();
        work();
    }

    private static void work() {
        while (!JOBS.isEmpty()) {
            JOBS.remove(0);
        }
    }
}
