package programs.failing.runaways;

/**
 * A state machine without a sleep ends at the time limit.
 *
 * @expected time-limit
 * @limit 1 s
 */
public class SwitchInALoop {
    public static void main(String[] args) {
        int state = 0;
        do {
            switch (state) {
                case 0:
                    state = 1;
                    continue;
                case 1:
                    state = 2;
                    break;
                default:
                    state = 0;
            }
        } while (state >= 0);
    }
}
