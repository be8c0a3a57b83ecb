package brickless.bench;

/**
 * How much is measured.
 *
 * @param simulatedSeconds length of a program's run
 * @param warmUpMillis host time for the compiler of the JVM to do its work before anything counts
 * @param rounds measurements of which the median is taken
 * @param nest whether measurements may start JVMs of their own
 */
public record Effort(int simulatedSeconds, long warmUpMillis, int rounds, boolean nest) {
    /** What the documentation tells. */
    static final Effort FULL = new Effort(600, 8_000, 3, true);
    /** For a quick look. */
    static final Effort SHORT = new Effort(120, 2_000, 2, true);
    /** Shows that everything works; the numbers mean nothing. */
    static final Effort TRIAL = new Effort(1, 0, 1, false);

    /** By name. */
    static Effort of(String name) {
        return switch (name) {
            case "full" -> FULL;
            case "short" -> SHORT;
            case "trial" -> TRIAL;
            default -> throw new IllegalArgumentException("effort is full, short or trial, not " + name);
        };
    }
}
