package brickless.bench;

import java.util.Collection;
import java.util.Comparator;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.openjdk.jmh.runner.options.VerboseMode;

/** Runs {@link HotPieces} with JMH: nanoseconds for each. */
final class Pieces implements Measurement {
    @Override
    public Figures measure(Effort effort) throws RunnerException {
        boolean trial = !effort.nest();
        TimeValue time = TimeValue.milliseconds(trial ? 1 : Math.max(200, effort.warmUpMillis() / 10));
        ChainedOptionsBuilder options = new OptionsBuilder().include(HotPieces.class.getName() + "\\..*")
                .forks(trial ? 0 : 1)
                .warmupIterations(trial ? 0 : 5).warmupTime(time).measurementIterations(trial ? 1 : 5)
                .measurementTime(time).verbosity(VerboseMode.SILENT).shouldFailOnError(true);
        if (trial) {
            options = options.exclude("contextSwitch|tick");
        }
        Collection<RunResult> results = new Runner(options.jvmArgsAppend("-XX:+UseSerialGC").build()).run();
        Figures figures = new Figures();
        results.stream().sorted(Comparator.comparing(r -> r.getPrimaryResult().getLabel()))
                .forEach(r -> figures.put(r.getPrimaryResult().getLabel() + "Nanos", r.getPrimaryResult().getScore()));
        return figures;
    }
}
