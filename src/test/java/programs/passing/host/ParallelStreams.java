package programs.passing.host;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Parallel streams run on the calling thread, in order.
 *
 * @expected exited 0
 * @prints a on main
 * @prints b on main
 * @prints 45 on main
 */
public class ParallelStreams {
    public static void main(String[] args) {
        List<String> words = Arrays.asList("a", "b");
        words.parallelStream().forEach(word -> System.out.println(word + " on " + Thread.currentThread().getName()));
        int sum = IntStream.range(0, 10).parallel().map(i -> {
            Thread.yield();
            return i;
        }).sum();
        System.out.println(sum + " on " + Thread.currentThread().getName());
    }
}
