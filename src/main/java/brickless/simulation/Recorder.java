package brickless.simulation;

import brickless.trace.PathDrawing;
import brickless.trace.ReportRecording;
import brickless.trace.Sample;
import brickless.trace.SignalsWriter;
import brickless.trace.TraceEvent;
import brickless.trace.TraceHeader;
import brickless.trace.TraceListener;
import brickless.trace.TraceWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/**
 * Writes down a run: trace with hash always, the other files if there is a folder for them. What comes after
 * {@link #finish} is dropped: in live mode threads of the program outlive the run. Used by one thread at a time.
 */
final class Recorder {
    private final Optional<RunFolder> folder;
    private final TraceWriter trace;
    private final Optional<SignalsWriter> signals;
    private final OutputStream console;
    private final PathDrawing path = new PathDrawing();
    private final Optional<ReportRecording> recording;
    private final TraceListener listener;
    private boolean finished;

    Recorder(Optional<RunFolder> folder, TraceHeader header, TraceListener listener) {
        this.folder = folder;
        this.listener = listener;
        trace = new TraceWriter(folder.map(f -> f.open("trace.jsonl"))
                .orElseGet(OutputStream::nullOutputStream), header);
        signals = folder.map(f ->
                new SignalsWriter(new OutputStreamWriter(f.open("signals.csv"), StandardCharsets.UTF_8)));
        recording = folder.map(f -> new ReportRecording());
        recording.ifPresent(r -> r.header(header));
        console = folder.map(f -> f.open("console.txt")).orElseGet(OutputStream::nullOutputStream);
        listener.header(header);
    }

    void event(long timeNanos, String robot, TraceEvent event) {
        if (finished) {
            return;
        }
        trace.event(timeNanos, robot, event);
        recording.ifPresent(r -> r.event(timeNanos, robot, event));
        listener.event(timeNanos, robot, event);
    }

    void sample(Sample sample) {
        if (finished) {
            return;
        }
        trace.sample(sample);
        signals.ifPresent(s -> s.sample(sample));
        recording.ifPresent(r -> r.sample(sample));
        listener.sample(sample);
        path.sample(sample);
    }

    void console(byte[] bytes, int offset, int length) {
        if (finished) {
            return;
        }
        try {
            console.write(bytes, offset, length);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write console.txt", e);
        }
    }

    /** The run for its report. */
    ReportRecording recording() {
        return recording.orElseThrow(() -> new IllegalStateException("a run without a folder keeps no recording"));
    }

    PathDrawing path() {
        return path;
    }

    /** Ends the trace and returns its hash. */
    String finish() {
        finished = true;
        try {
            trace.close();
            console.close();
            if (signals.isPresent()) {
                signals.get().close();
            }
        } catch (IOException e) {
            throw new UncheckedIOException("cannot finish the files of the run", e);
        }
        return trace.hash();
    }
}
