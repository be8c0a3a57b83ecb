package programs.passing.exit;

import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

/**
 * System.exit in takeControl, which the arbitrator's own thread calls while an action runs, ends the program at once.
 *
 * @expected exited 5
 * @contains working
 */
public class ExitInsideTakeControl {
    public static void main(String[] args) {
        new Arbitrator(new Behavior[] {new Work(), new Quit()}).go();
    }

    private static class Work implements Behavior {
        @Override
        public boolean takeControl() {
            return true;
        }

        @Override
        public void action() {
            System.out.println("working");
            while (true) {
                Thread.yield();
            }
        }

        @Override
        public void suppress() {
            System.out.println("suppressed");
        }
    }

    private static class Quit implements Behavior {
        @Override
        public boolean takeControl() {
            if (System.currentTimeMillis() % 1_000 > 500) {
                System.exit(5);
            }
            return false;
        }

        @Override
        public void action() {
            System.out.println("never");
        }

        @Override
        public void suppress() {
            System.out.println("never");
        }
    }
}
