package programs.passing.concurrency;

import java.io.PrintWriter;
import java.io.StringWriter;

/**
 * Objects whose toString sleeps and takes a lock, appended, inserted and printed by two threads: no lock of the JDK's
 * buffers and writers is held meanwhile.
 *
 * @expected exited 0
 * @prints 120 characters
 * @schedules 20
 */
public class TextOfObjects {
    private static final StringBuffer BUFFER = new StringBuffer();
    private static final StringWriter TEXT = new StringWriter();

    private static final class Slow {
        @Override
        public synchronized String toString() {
            try {
                Thread.sleep(3);
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
            return "ab";
        }
    }

    /** The program. */
    public static void main(String[] args) throws InterruptedException {
        Slow shared = new Slow();
        PrintWriter writer = new PrintWriter(TEXT);
        Runnable work = () -> {
            for (int i = 0; i < 10; i++) {
                BUFFER.append(shared);
                BUFFER.insert(0, (Object) shared);
                writer.print(shared);
            }
        };
        Thread other = new Thread(work);
        other.start();
        work.run();
        other.join();
        System.out.println(BUFFER.length() + TEXT.toString().length() + " characters");
    }
}
