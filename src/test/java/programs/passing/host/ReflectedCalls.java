package programs.passing.host;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;

/**
 * Calls by reflection go through virtual time, too.
 *
 * @expected exited 0
 * @prints slept 500 ms
 * @prints main
 * @prints refused java.lang.IllegalMonitorStateException
 * @prints own method
 */
public class ReflectedCalls {
    private static void own() {
        System.out.println("own method");
    }

    public static void main(String[] args) throws Exception {
        long start = System.currentTimeMillis();
        Thread.class.getMethod("sleep", long.class).invoke(null, 500L);
        Method clock = System.class.getMethod("currentTimeMillis");
        System.out.println("slept " + ((Long) clock.invoke(null) - start) + " ms");
        Thread current = (Thread) Thread.class.getMethod("currentThread").invoke(null);
        System.out.println(current.getName());
        try {
            Object.class.getMethod("notify").invoke(new Object());
        } catch (InvocationTargetException e) {
            System.out.println("refused " + e.getCause().getClass().getName());
        }
        ReflectedCalls.class.getDeclaredMethod("own").invoke(null);
    }
}
