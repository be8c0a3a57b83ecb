package programs.passing.initialisers;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;

/**
 * An enum whose constants take locks while they are made, used from several threads, directly and through the JDK.
 *
 * @expected exited 0
 * @prints 3 LEFT RIGHT [LEFT, RIGHT, AHEAD] {AHEAD=3} 3
 * @schedules 40
 */
public class EnumConstants {
    enum Direction {
        LEFT, RIGHT, AHEAD {
            @Override
            int number() {
                return 3;
            }
        };

        private final int number = Counter.next();

        int number() {
            return number;
        }
    }

    static final class Counter {
        private static int count;

        static synchronized int next() {
            for (int i = 0; i < 3; i++) {
                Thread.yield();
            }
            return ++count;
        }
    }

    private static final String[] SEEN = new String[5];

    public static void main(String[] args) throws InterruptedException {
        Thread[] threads = {
            new Thread(() -> SEEN[0] = Integer.toString(Direction.AHEAD.number())),
            new Thread(() -> SEEN[1] = Direction.valueOf("LEFT") + " " + Enum.valueOf(Direction.class, "RIGHT")),
            new Thread(() -> SEEN[2] = EnumSet.allOf(Direction.class).toString()),
            new Thread(() -> {
                Map<Direction, Integer> numbers = new EnumMap<>(Direction.class);
                numbers.put(Direction.AHEAD, 3);
                SEEN[3] = numbers.toString();
            }),
            new Thread(() -> SEEN[4] = Integer.toString(Direction.class.getEnumConstants().length))};
        for (Thread thread : threads) {
            thread.start();
        }
        for (Thread thread : threads) {
            thread.join();
        }
        System.out.println(String.join(" ", SEEN));
    }
}
