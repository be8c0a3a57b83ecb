package programs.passing.concurrency;

import java.util.Collections;
import java.util.Enumeration;
import java.util.Hashtable;
import java.util.Map;
import java.util.Stack;
import java.util.TreeMap;
import java.util.Vector;

/**
 * Vector, Stack, Hashtable and synchronized wrappers print what they print on a PC.
 *
 * @expected exited 0
 * @prints [c, a, b] b
 * @prints top 3 of [1, 2, 3]
 * @prints {two=2, one=1, three=3}
 * @prints two one three
 * @prints {a=1, b=2}
 * @prints true
 */
public class OldCollections {
    /** The program. */
    public static void main(String[] args) throws Exception {
        Vector<String> vector = new Vector<>();
        vector.addElement("a");
        vector.addElement("b");
        vector.insertElementAt("c", 0);
        System.out.println(vector + " " + vector.lastElement());
        Stack<Integer> stack = new Stack<>();
        stack.push(1);
        stack.push(2);
        stack.push(3);
        System.out.println("top " + stack.peek() + " of " + stack);
        Hashtable<String, Integer> table = new Hashtable<>();
        table.put("one", 1);
        table.put("two", 2);
        table.put("three", 3);
        System.out.println(table);
        StringBuilder keys = new StringBuilder();
        for (Enumeration<String> e = table.keys(); e.hasMoreElements();) {
            keys.append(e.nextElement()).append(e.hasMoreElements() ? " " : "");
        }
        System.out.println(keys);
        Map<String, Integer> map = Collections.synchronizedSortedMap(new TreeMap<>());
        map.put("b", 2);
        map.put("a", 1);
        System.out.println(map);
        System.out.println(map.equals(Map.of("a", 1, "b", 2)));
    }
}
