package brickless.viewer;

import brickless.simulation.Durations;
import brickless.simulation.StimuliReader;
import brickless.simulation.Stimulus;
import brickless.world.DescriptionException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Pattern;

/** What viewers did to a run, as stimuli that repeat it. Owned by the driver. */
final class Touches {
    /** A session of hours; beyond that somebody plays with the server, not with the robot. */
    private static final int MOST = 100_000;
    private static final Pattern WORDS = Pattern.compile("[^\\p{Cntrl}\\u0085\\u2028\\u2029#]{1,200}");

    private final List<Stimulus> stimuli;
    private final int planned;

    /** Begins with the stimuli of the run's settings. */
    Touches(List<Stimulus> planned) {
        this.stimuli = new ArrayList<>(planned);
        this.planned = planned.size();
    }

    /** Number of touches. */
    int count() {
        return stimuli.size() - planned;
    }

    /**
     * What words of the stimuli file mean at a time. A key that is pressed for some time is held and released: a
     * program that is pressed keys for must not know beforehand.
     *
     * @throws RefusedException if they mean nothing
     */
    List<Stimulus> read(String words, long atNanos, long stepNanos) {
        if (count() >= MOST) {
            throw new RefusedException("this run was touched too often; restart it");
        }
        if (!WORDS.matcher(words).matches()) {
            throw new RefusedException("'stimulus' is one line of at most 200 characters without #");
        }
        try {
            List<Stimulus> read = StimuliReader.readText("stimulus", text(atNanos) + " " + words);
            return read.stream().flatMap(stimulus -> unplanned(stimulus, stepNanos).stream()).toList();
        } catch (DescriptionException e) {
            throw new RefusedException(e.getMessage().replaceFirst("^stimulus:1: ", ""));
        }
    }

    /** Notes what was done. */
    void add(Stimulus stimulus) {
        stimuli.add(stimulus);
    }

    private static List<Stimulus> unplanned(Stimulus stimulus, long stepNanos) {
        if (stimulus instanceof Stimulus.On on && on.what() instanceof Stimulus.Press press) {
            return holdAndRelease(press, stepNanos).stream()
                    .<Stimulus>map(part -> new Stimulus.On(on.robot(), part)).toList();
        }
        return stimulus instanceof Stimulus.Press press ? holdAndRelease(press, stepNanos) : List.of(stimulus);
    }

    private static List<Stimulus> holdAndRelease(Stimulus.Press press, long stepNanos) {
        Stimulus.Key key = new Stimulus.Key(press.keyMask());
        String name = press.text().split(" ")[1];
        long steps = Math.max(1, press.forNanos() / stepNanos);
        return List.of(new Stimulus.Hold(press.atNanos(), key, "hold key " + name),
                new Stimulus.Release(press.atNanos() + steps * stepNanos, key, "release key " + name));
    }

    /**
     * The stimuli file.
     *
     * @param command the command that repeats the session with it
     */
    String file(String command) {
        StringBuilder text = new StringBuilder(
                "# What was done to the robots in a live session. Saved as stimuli.txt, this repeats it exactly:\n# ")
                .append(command).append('\n');
        stimuli.stream().sorted(Comparator.comparingLong(Stimulus::atNanos))
                .forEach(stimulus -> text.append(text(stimulus.atNanos())).append(' ').append(stimulus.text())
                        .append('\n'));
        return text.toString();
    }

    private static String text(long nanos) {
        return Durations.text(Duration.ofNanos(nanos));
    }
}
