package brickless.bench;

import brickless.kernel.Kernel;
import brickless.kernel.KernelSettings;
import brickless.loading.LoadingRules;
import brickless.loading.RobotClassLoader;
import java.lang.reflect.Method;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * What rewriting costs programs that compute: how many times longer {@link Loops} take rewritten than plain, best of
 * some rounds in host time. At most 3 times as long is wanted.
 */
final class ComputeCost implements Measurement {
    private static final List<String> LOOPS = List.of("matrix", "sieve", "collatz", "particles", "fibonacci", "sort");
    private static final int ROUNDS = 60;

    @Override
    public Figures measure(Effort effort) {
        int rounds = effort.nest() ? ROUNDS : 1;
        Map<String, Long> plain = measure(Loops.class, rounds);
        Map<String, Long> rewritten = new TreeMap<>();
        RobotClassLoader loader = RobotClassLoader.ofApplication(ComputeCost.class.getClassLoader(),
                LoadingRules.standard().rewriting(Loops.class.getName()));
        Kernel kernel = new Kernel(KernelSettings.defaults().withLimitNanos(Long.MAX_VALUE)
                .withStepNanos(2_000_000), time -> { });
        kernel.bind(loader.bind(kernel));
        Thread main = loader.programThread("main", () -> {
            try {
                rewritten.putAll(measure(loader.loadClass(Loops.class.getName()), rounds));
            } catch (ClassNotFoundException e) {
                throw new IllegalStateException(e);
            }
        });
        kernel.run(main, main);
        Figures figures = new Figures();
        plain.forEach((name, nanos) -> figures.put(name, (double) rewritten.get(name) / nanos));
        return figures;
    }

    private static Map<String, Long> measure(Class<?> loops, int rounds) {
        Map<String, Long> best = new TreeMap<>();
        for (String name : LOOPS) {
            for (int round = 0; round < rounds; round++) {
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
