package programs.failing.runaways;

/**
 * An empty endless loop ends at the time limit.
 *
 * @expected time-limit
 * @limit 60 s
 */
public class EndlessLoop {
    public static void main(String[] args) {
        while (true) {
        }
    }
}
