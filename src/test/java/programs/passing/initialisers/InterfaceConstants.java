package programs.passing.initialisers;

/**
 * Constants of an interface that are made by a synchronized method, used from two threads, whoever comes first.
 *
 * @expected exited 0
 * @prints 3
 * @schedules 40
 */
public class InterfaceConstants {
    interface Settings {
        int[] FIRST = Maker.make(1);
        int[] SECOND = Maker.make(2);
    }

    static final class Maker {
        static synchronized int[] make(int value) {
            int[] made = new int[1];
            for (int i = 0; i < value; i++) {
                made[0]++;
            }
            return made;
        }
    }

    private static int sum;

    static synchronized void add(int value) {
        sum += value;
    }

    public static void main(String[] args) throws InterruptedException {
        Thread first = new Thread(() -> add(Settings.FIRST[0]));
        Thread second = new Thread(() -> add(Settings.SECOND[0]));
        first.start();
        second.start();
        first.join();
        second.join();
        System.out.println(sum);
    }
}
