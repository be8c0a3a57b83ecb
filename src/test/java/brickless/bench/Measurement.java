package brickless.bench;

/** Something that is measured in a JVM of its own. */
@FunctionalInterface
public interface Measurement {
    /** Measures. */
    Figures measure(Effort effort) throws Exception;
}
