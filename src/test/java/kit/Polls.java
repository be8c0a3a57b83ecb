package kit;

import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;
import lejos.utility.Delay;

/** How often a behaviour is asked while another one acts for a second. */
public final class Polls implements Behavior {
    private int asked;

    private Polls() {}

    public static void main(String[] args) {
        Polls higher = new Polls();
        boolean[] done = {false};
        Behavior lower = new Behavior() {
            @Override
            public boolean takeControl() {
                return !done[0];
            }

            @Override
            public void action() {
                int before = higher.asked;
                Delay.msDelay(1000);
                System.out.println("asked " + (higher.asked - before));
                done[0] = true;
            }

            @Override
            public void suppress() {
                System.out.println("never suppressed");
            }
        };
        new Arbitrator(new Behavior[] {lower, higher}, true).go();
    }

    @Override
    public boolean takeControl() {
        asked++;
        return false;
    }

    @Override
    public void action() {
        System.out.println("never acts");
    }

    @Override
    public void suppress() {
        System.out.println("never suppressed");
    }
}
