package kit;

import lejos.utility.Delay;

/** Waits long enough to see what happens to another robot whose program is over. */
public final class Follower {
    private Follower() {}

    public static void main(String[] args) {
        Delay.msDelay(4000);
    }
}
