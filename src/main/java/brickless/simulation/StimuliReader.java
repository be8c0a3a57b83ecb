package brickless.simulation;

import brickless.world.DescriptionException;
import brickless.world.Pose2;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads stimuli files: one stimulus per line, {@code TIME WHAT … [on ROBOT]}, {@code #} begins a comment. */
public final class StimuliReader {
    /** Keys by name, in the order of their bits. */
    static final Map<String, Integer> KEYS = new LinkedHashMap<>();
    private static final Map<String, Integer> REMOTE = new LinkedHashMap<>();
    private static final Pattern DECIBELS = Pattern.compile("(\\d{1,4}(?:\\.\\d{1,6})?)dB");
    private static final Pattern VOLTS = Pattern.compile("(\\d{1,4}(?:\\.\\d{1,6})?)V");
    private static final String NUMBER = "-?\\d{1,6}(?:\\.\\d{1,6})?";
    private static final Pattern PLACE = Pattern.compile("(" + NUMBER + "),(" + NUMBER + ")");
    private static final String ALLOWED =
            "allowed: press KEY DURATION, push S1..S4 DURATION, remote CHANNEL BUTTON DURATION, clap LEVELdB, "
            + "move NAME X,Y DEGREES, remove NAME, battery VOLTSV, hold or release key KEY, push S1..S4 or remote "
            + "CHANNEL BUTTON; 'on ROBOT' behind it names another robot than the first";

    static {
        String[] keys = {"UP", "ENTER", "DOWN", "RIGHT", "LEFT", "ESCAPE"};
        for (int i = 0; i < keys.length; i++) {
            KEYS.put(keys[i], 1 << i);
        }
        String[] buttons = {"TOP_LEFT", "BOTTOM_LEFT", "TOP_RIGHT", "BOTTOM_RIGHT", "BOTH_TOP", "TOP_LEFT+BOTTOM_RIGHT",
            "BOTTOM_LEFT+TOP_RIGHT", "BOTH_BOTTOM", "BEACON", "BOTH_LEFT", "BOTH_RIGHT"};
        for (int i = 0; i < buttons.length; i++) {
            REMOTE.put(buttons[i], i + 1);
        }
    }

    private final String file;
    private int lineNumber;

    private StimuliReader(String file) {
        this.file = file;
    }

    /**
     * Reads a file.
     *
     * @return the stimuli in order of time
     * @throws DescriptionException located, if the file cannot be read or understood
     */
    public static List<Stimulus> read(Path path) throws DescriptionException {
        try {
            return readText(path.toString(), Files.readString(path));
        } catch (IOException e) {
            throw new DescriptionException(path.toString(), 0, "", "cannot be read: no such file, or not UTF-8 text");
        }
    }

    /** Reads text; {@code file} names it in messages. */
    public static List<Stimulus> readText(String file, String text) throws DescriptionException {
        StimuliReader reader = new StimuliReader(file);
        List<Stimulus> stimuli = new ArrayList<>();
        for (String line : text.split("\\R", -1)) {
            reader.lineNumber++;
            String content = line.replaceFirst("#.*", "").strip();
            if (!content.isEmpty()) {
                stimuli.add(reader.line(content.split("\\s+")));
            }
        }
        stimuli.sort(Comparator.comparingLong(Stimulus::atNanos));
        return stimuli;
    }

    private Stimulus line(String[] words) throws DescriptionException {
        long at = nanos(words[0]);
        if (words.length < 2) {
            throw error("nothing to do at " + words[0] + "; " + ALLOWED);
        }
        int on = words.length - 2;
        if (on > 1 && words[on].equals("on")) {
            return new Stimulus.On(words[on + 1], what(at, Arrays.copyOf(words, on)));
        }
        return what(at, words);
    }

    private Stimulus what(long at, String[] words) throws DescriptionException {
        String text = String.join(" ", List.of(words).subList(1, words.length));
        switch (words[1].toLowerCase(Locale.ROOT)) {
            case "press":
                expect(words, 4);
                return new Stimulus.Press(at, oneOf(KEYS, words[2], "key"), nanos(words[3]), text);
            case "push":
                expect(words, 4);
                return new Stimulus.Push(at, sensorPort(words[2]), nanos(words[3]), text);
            case "remote":
                expect(words, 5);
                return new Stimulus.Remote(at, channel(words[2]), oneOf(REMOTE, words[3], "button"),
                        nanos(words[4]), text);
            case "hold":
                return new Stimulus.Hold(at, holdable(words), text);
            case "release":
                return new Stimulus.Release(at, holdable(words), text);
            case "clap":
                expect(words, 3);
                return new Stimulus.Clap(at, number(DECIBELS, words[2], "a level like 80dB"), text);
            case "move":
                expect(words, 5);
                return new Stimulus.Move(at, words[2], pose(words[3], words[4]), text);
            case "remove":
                expect(words, 3);
                return new Stimulus.Remove(at, words[2], text);
            case "battery":
                expect(words, 3);
                return new Stimulus.Battery(at, number(VOLTS, words[2], "a voltage like 6.9V"), text);
            default:
                throw error("unknown stimulus '" + words[1] + "'; " + ALLOWED);
        }
    }

    private Stimulus.Holdable holdable(String[] words) throws DescriptionException {
        String kind = words.length < 3 ? "" : words[2].toLowerCase(Locale.ROOT);
        switch (kind) {
            case "key":
                expect(words, 4);
                return new Stimulus.Key(oneOf(KEYS, words[3], "key"));
            case "push":
                expect(words, 4);
                return new Stimulus.TouchSensor(sensorPort(words[3]));
            case "remote":
                expect(words, 5);
                return new Stimulus.RemoteButton(channel(words[3]), oneOf(REMOTE, words[4], "button"));
            default:
                throw error("'" + words[1] + "' needs what to " + words[1] + "; " + ALLOWED);
        }
    }

    private void expect(String[] words, int count) throws DescriptionException {
        if (words.length != count) {
            throw error("'" + words[1] + "' takes " + (count - 2) + " words, found " + (words.length - 2)
                    + "; " + ALLOWED);
        }
    }

    private long nanos(String word) throws DescriptionException {
        return Durations.parse(word).map(Duration::toNanos)
                .orElseThrow(() -> error("'" + word + "' is no duration; allowed: 500ms, 2.5s, 1m"));
    }

    private int oneOf(Map<String, Integer> names, String word, String what) throws DescriptionException {
        Integer value = names.get(word.toUpperCase(Locale.ROOT));
        if (value == null) {
            throw error("unknown " + what + " '" + word + "'; allowed: " + String.join(", ", names.keySet()));
        }
        return value;
    }

    private int sensorPort(String word) throws DescriptionException {
        if (!word.matches("S[1-4]")) {
            throw error("'" + word + "' is no sensor port; allowed: S1 to S4");
        }
        return word.charAt(1) - '1';
    }

    private int channel(String word) throws DescriptionException {
        if (!word.matches("[1-4]")) {
            throw error("'" + word + "' is no infrared channel; allowed: 1 to 4");
        }
        return word.charAt(0) - '0';
    }

    private double number(Pattern form, String word, String what) throws DescriptionException {
        Matcher matcher = form.matcher(word);
        if (!matcher.matches()) {
            throw error("'" + word + "' is not " + what);
        }
        return Double.parseDouble(matcher.group(1));
    }

    private Pose2 pose(String place, String degrees) throws DescriptionException {
        Matcher matcher = PLACE.matcher(place);
        if (!matcher.matches() || !degrees.matches(NUMBER)) {
            throw error("'" + place + " " + degrees + "' is not X,Y DEGREES in millimetres and degrees");
        }
        return new Pose2(Double.parseDouble(matcher.group(1)) / 1000, Double.parseDouble(matcher.group(2)) / 1000,
                StrictMath.toRadians(Double.parseDouble(degrees)));
    }

    private DescriptionException error(String message) {
        return new DescriptionException(file, lineNumber, "", message);
    }
}
