package programs.passing.host;

import java.util.Timer;
import java.util.Vector;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.locks.ReentrantLock;

/**
 * A program that asks sees that some classes of the JDK are replaced.
 *
 * @expected exited 0
 * @prints brickless.concurrent true
 * @prints brickless.concurrent true
 * @prints brickless.concurrent true
 * @prints java.util false
 */
public class ReplacedClassNames {
    public static void main(String[] args) {
        show(new ReentrantLock());
        show(new ArrayBlockingQueue<String>(1));
        show(new Vector<String>());
        show(new java.util.ArrayList<String>());
        new Timer().cancel();
    }

    private static void show(Object object) {
        boolean replaced = object.getClass().getName().startsWith("brickless.concurrent.");
        System.out.println((replaced ? "brickless.concurrent " : "java.util ") + replaced);
    }
}
