package programs.passing.concurrency;

/**
 * Two threads append to one StringBuffer; nothing is lost.
 *
 * @expected exited 0
 * @prints length 400
 * @prints left 200
 * @prints right 200
 */
public class SharedBuffer {
    private static void append(StringBuffer buffer, String text) {
        for (int i = 0; i < 200; i++) {
            buffer.append(text);
        }
    }

    /** The program. */
    public static void main(String[] args) throws Exception {
        StringBuffer buffer = new StringBuffer();
        Thread left = new Thread(() -> append(buffer, "l"));
        Thread right = new Thread(() -> append(buffer, "r"));
        left.start();
        right.start();
        left.join();
        right.join();
        String text = buffer.toString();
        System.out.println("length " + text.length());
        System.out.println("left " + text.replace("r", "").length());
        System.out.println("right " + text.replace("l", "").length());
    }
}
