package lejos.robotics.subsumption;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/**
 * Plays a random script with an arbitrator and tells the order of its calls.
 *
 * <p>Each action takes the next step of the script: it changes who wants to drive, waits until the monitor has looked
 * (until it is suppressed, if that is to be expected), and returns. The last step throws, which ends go in every
 * version. A behaviour above all others never wants anything; it counts passes.
 */
final class Scripted {
    private static final int STEPS = 12;

    private final Object changed = new Object();
    private final List<String> calls = Collections.synchronizedList(new ArrayList<>());
    private final Random random;
    private final int size;
    private volatile boolean[] wishes;
    private long passes;
    private long suppressions;
    private int steps;

    private Scripted(int seed) {
        random = new Random(seed);
        size = 1 + random.nextInt(5);
        wishes = draw();
    }

    /** The calls in order: the index of each action, and an S when it was suppressed. */
    static List<String> play(int seed) {
        Scripted script = new Scripted(seed);
        Behavior[] behaviors = new Behavior[script.size + 1];
        for (int i = 0; i < script.size; i++) {
            behaviors[i] = script.new Step(i);
        }
        behaviors[script.size] = script.new Counter();
        Arbitrator arbitrator = new Arbitrator(behaviors);
        try {
            arbitrator.go();
            script.calls.add("returned");
        } catch (IllegalStateException end) {
            script.calls.add(end.getMessage());
        }
        arbitrator.stop();
        return new ArrayList<>(script.calls);
    }

    /** At least one behaviour wants to drive. */
    private boolean[] draw() {
        boolean[] drawn = new boolean[size];
        for (int i = 0; i < size; i++) {
            drawn[i] = random.nextInt(3) == 0;
        }
        drawn[random.nextInt(size)] = true;
        return drawn;
    }

    private static int highest(boolean[] wishes) {
        int index = wishes.length - 1;
        while (!wishes[index]) {
            index--;
        }
        return index;
    }

    private final class Step implements Behavior {
        private final int index;

        Step(int index) {
            this.index = index;
        }

        @Override
        public boolean takeControl() {
            return wishes[index];
        }

        @Override
        public void action() {
            calls.add(Integer.toString(index));
            synchronized (changed) {
                if (++steps == STEPS) {
                    throw new IllegalStateException("end of script");
                }
                suppressions = 0;
                wishes = draw();
                boolean outvoted = highest(wishes) > index;
                long until = passes + 3;
                while (outvoted ? suppressions < 2 : passes < until) {
                    waitForChange();
                }
                if (suppressions > 0) {
                    calls.add("S");
                }
            }
        }

        @Override
        public void suppress() {
            synchronized (changed) {
                suppressions++;
                changed.notifyAll();
            }
        }
    }

    private final class Counter implements Behavior {
        @Override
        public boolean takeControl() {
            synchronized (changed) {
                passes++;
                changed.notifyAll();
            }
            return false;
        }

        @Override
        public void action() {
            throw new AssertionError("nobody asked for this");
        }

        @Override
        public void suppress() {
            throw new AssertionError("never acts");
        }
    }

    private void waitForChange() {
        try {
            changed.wait();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }
}
