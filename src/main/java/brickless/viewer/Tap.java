package brickless.viewer;

import brickless.trace.ReportRecording;
import brickless.trace.Sample;
import brickless.trace.TraceEvent;
import brickless.trace.TraceHeader;
import brickless.trace.TraceLine;
import brickless.trace.TraceListener;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Hears the trace of a run: collects all of it for viewers that come later, and what is new for those that are there.
 * Written by the run's thread while the driver waits for it, read by the driver while the run is held.
 */
final class Tap implements TraceListener {
    private record Happening(long timeNanos, String robot, TraceEvent event) {}

    private final ReportRecording recording = new ReportRecording();
    private final List<Happening> fresh = new ArrayList<>();
    private TraceHeader header;
    private Sample newest;

    @Override
    public void header(TraceHeader value) {
        header = value;
        recording.header(value);
    }

    @Override
    public void sample(Sample sample) {
        newest = sample;
        recording.sample(sample);
    }

    @Override
    public void event(long timeNanos, String robot, TraceEvent event) {
        fresh.add(new Happening(timeNanos, robot, event));
        recording.event(timeNanos, robot, event);
    }

    TraceHeader header() {
        return header;
    }

    /** Everything so far. */
    ReportRecording recording() {
        return recording;
    }

    /** The newest sample, if there is one since the last call. */
    Optional<Sample> takeSample() {
        Optional<Sample> sample = Optional.ofNullable(newest);
        newest = null;
        return sample;
    }

    /** Lines of the events since the last call; of several changes of one screen only their sum. */
    List<String> takeEvents() {
        Map<String, Integer> lastScreens = new LinkedHashMap<>();
        Map<String, TreeMap<Integer, String>> screens = new LinkedHashMap<>();
        for (int i = 0; i < fresh.size(); i++) {
            if (fresh.get(i).event() instanceof TraceEvent.ScreenEvent screen) {
                lastScreens.put(fresh.get(i).robot(), i);
                TreeMap<Integer, String> rows = screens.computeIfAbsent(fresh.get(i).robot(), robot -> new TreeMap<>());
                for (int k = 0; k < screen.rows().size(); k++) {
                    rows.put(screen.rows().get(k), screen.pixels().get(k));
                }
            }
        }
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < fresh.size(); i++) {
            Happening happening = fresh.get(i);
            if (!(happening.event() instanceof TraceEvent.ScreenEvent)) {
                lines.add(TraceLine.event(happening.timeNanos(), happening.robot(), happening.event()));
            } else if (lastScreens.get(happening.robot()) == i) {
                TreeMap<Integer, String> rows = screens.get(happening.robot());
                lines.add(TraceLine.event(happening.timeNanos(), happening.robot(),
                        new TraceEvent.ScreenEvent(List.copyOf(rows.keySet()), List.copyOf(rows.values()))));
            }
        }
        fresh.clear();
        return lines;
    }

    /** Forgets what is new: nobody watches. */
    void skip() {
        fresh.clear();
        newest = null;
    }
}
