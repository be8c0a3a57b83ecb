package programs.passing.concurrency;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintStream;

/**
 * A thread prints words into a pipe, the main thread reads lines.
 *
 * @expected exited 0
 * @prints read one
 * @prints read two
 * @prints read 2.5
 * @prints end
 */
public class PipedWords {
    /** The program. */
    public static void main(String[] args) throws Exception {
        PipedInputStream in = new PipedInputStream(4);
        PipedOutputStream out = new PipedOutputStream(in);
        Thread printer = new Thread(() -> {
            PrintStream words = new PrintStream(out, true);
            words.println("one");
            words.printf("%s%n", "two");
            words.println(2.5);
            words.close();
        });
        printer.start();
        BufferedReader reader = new BufferedReader(new InputStreamReader(in));
        for (String line = reader.readLine(); line != null; line = reader.readLine()) {
            System.out.println("read " + line);
        }
        printer.join();
        System.out.println("end");
    }
}
