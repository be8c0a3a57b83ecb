package programs.passing.concurrency;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Hashtable;
import java.util.List;
import java.util.Vector;

/**
 * Who holds the monitor of a vector, a table or a synchronized list keeps everybody else out.
 *
 * @expected exited 0
 * @prints vector still 1
 * @prints vector now 2
 * @prints table still 1
 * @prints table now 2
 * @prints list still 1
 * @prints list now 2
 */
public class VectorGuardedByItself {
    /** The program. */
    public static void main(String[] args) throws Exception {
        Vector<String> vector = new Vector<>();
        vector.add("a");
        Thread adder = new Thread(() -> vector.add("b"));
        synchronized (vector) {
            adder.start();
            Thread.sleep(20);
            System.out.println("vector still " + vector.size());
        }
        adder.join();
        System.out.println("vector now " + vector.size());
        Hashtable<String, Integer> table = new Hashtable<>();
        table.put("a", 1);
        Thread putter = new Thread(() -> table.put("b", 2));
        synchronized (table) {
            putter.start();
            Thread.sleep(20);
            System.out.println("table still " + table.size());
        }
        putter.join();
        System.out.println("table now " + table.size());
        List<String> list = Collections.synchronizedList(new ArrayList<>());
        list.add("a");
        Thread appender = new Thread(() -> list.add("b"));
        synchronized (list) {
            appender.start();
            Thread.sleep(20);
            System.out.println("list still " + list.size());
        }
        appender.join();
        System.out.println("list now " + list.size());
    }
}
