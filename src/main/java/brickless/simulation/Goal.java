package brickless.simulation;

import java.util.Optional;

/**
 * What a run is to reach ({@code --until}).
 *
 * @param zone zone that a robot must enter; empty: the program's own end
 */
public record Goal(Optional<String> zone) {
    /** Parses {@code zone:NAME} or {@code exit}; empty if it is neither. */
    public static Optional<Goal> parse(String text) {
        if (text.equals("exit")) {
            return Optional.of(new Goal(Optional.empty()));
        }
        return text.startsWith("zone:") && text.length() > 5
                ? Optional.of(new Goal(Optional.of(text.substring(5)))) : Optional.empty();
    }

    /** As {@link #parse} takes it. */
    public String text() {
        return zone.map(name -> "zone:" + name).orElse("exit");
    }

    /** Whether an outcome means that the goal was reached. */
    public boolean reachedBy(Outcome outcome) {
        return zone.isPresent() ? outcome.kind().equals("goal-reached")
                : outcome.kind().equals("exited") && outcome.successful();
    }
}
