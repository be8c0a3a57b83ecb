/**
 * Benchmarks: {@code ./gradlew bench}. {@link brickless.bench.Bench} starts a new JVM of every JDK for every case and
 * makes a table and {@code build/bench.json} of what they measure; method and results are in
 * {@code sim/docs/PERFORMANCE.md}.
 */
package brickless.bench;
