package programs.passing.statics;

/**
 * Static fields of every type, private ones and arrays among them, change over time; none is touched by a robot beside.
 *
 * @expected exited 0
 * @prints true 3 c 1003 100003 10000000003 3.5 4.5 text3 [0, 1, 2] 7 constant
 * @prints the same again
 */
public class KindsOfStatics {
    static final String CONSTANT = "constant";
    static final int[] TABLE = {0, 0, 0};
    private static boolean flag;
    private static byte small;
    private static char letter = '`';
    private static short medium = 1000;
    private static int number = 100_000;
    private static long large = 10_000_000_000L;
    private static float single = 0.5f;
    private static double real = 1.5;
    private static String text;

    /** No initialiser at all. */
    static class Plain {
        static int count;
    }

    static void pause() {
        try {
            Thread.sleep((long) (Math.random() * 10));
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    static String all() {
        return flag + " " + small + " " + letter + " " + medium + " " + number + " " + large + " " + single + " "
                + real + " " + text + " " + java.util.Arrays.toString(TABLE) + " " + Plain.count + " " + CONSTANT;
    }

    public static void main(String[] args) {
        for (int i = 0; i < 3; i++) {
            pause();
            flag = !flag;
            small++;
            letter++;
            medium++;
            number++;
            large++;
            single++;
            real++;
            text = "text" + (i + 1);
            TABLE[i] = i;
        }
        for (int i = 0; i < 7; i++) {
            pause();
            Plain.count++;
        }
        String before = all();
        System.out.println(before);
        pause();
        System.out.println(before.equals(all()) ? "the same again" : all());
    }
}
