package programs.failing.runaways;

import java.util.stream.Stream;

/**
 * An endless loop inside a JDK method ends at the time limit as long as it calls the program back.
 *
 * @expected time-limit
 * @limit 1 s
 */
public class LoopInTheJdk {
    public static void main(String[] args) {
        Stream.generate(() -> 1).forEach(number -> { });
    }
}
