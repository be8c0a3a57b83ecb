package brickless.bench;

import brickless.kernel.Kernel;
import brickless.kernel.KernelSettings;
import brickless.loading.LoadingRules;
import brickless.loading.RobotClassLoader;
import java.lang.reflect.Method;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * What rewriting costs programs that compute: {@link Loops} plain and rewritten, best of some rounds in host time. At most 3 times as long
 * is wanted.
 */
public final class ComputeCost {
    private static final List<String> LOOPS = List.of("matrix", "sieve", "collatz", "particles", "fibonacci", "sort");
    private static final int ROUNDS = 60;

    private ComputeCost() {}

    /** Runs the benchmark. */
    public static void main(String[] args) {
        Map<String, Long> plain = measure(Loops.class);
        Map<String, Long> rewritten = new TreeMap<>();
        RobotClassLoader loader = RobotClassLoader.ofApplication(ComputeCost.class.getClassLoader(),
                LoadingRules.standard().rewriting(Loops.class.getName()));
        Kernel kernel = new Kernel(KernelSettings.defaults().withLimitNanos(Long.MAX_VALUE).withStepNanos(2_000_000), time -> { });
        kernel.bind(loader.bind(kernel));
        Thread main = loader.programThread("main", () -> {
            try {
                rewritten.putAll(measure(loader.loadClass(Loops.class.getName())));
            } catch (ClassNotFoundException e) {
                throw new IllegalStateException(e);
            }
        });
        kernel.run(main, main);
        System.out.println("JDK " + Runtime.version());
        plain.forEach((name, nanos) -> System.out.printf(Locale.ROOT, "%-10s plain %7.2f ms, rewritten %7.2f ms, ratio %.2f%n", name,
                nanos / 1e6, rewritten.get(name) / 1e6, (double) rewritten.get(name) / nanos));
    }

    private static Map<String, Long> measure(Class<?> loops) {
        Map<String, Long> best = new TreeMap<>();
        for (String name : LOOPS) {
            for (int round = 0; round < ROUNDS; round++) {
                best.merge(name, nanos(loops, name), Math::min);
            }
        }
        return best;
    }

    private static long nanos(Class<?> loops, String name) {
        try {
            Method loop = loops.getMethod(name);
            long begin = System.nanoTime();
            loop.invoke(null);
            return System.nanoTime() - begin;
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }
}
