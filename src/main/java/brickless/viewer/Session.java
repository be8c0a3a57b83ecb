package brickless.viewer;

import brickless.simulation.Run;
import brickless.simulation.RunReport;
import brickless.simulation.SetupException;
import brickless.simulation.Simulation;
import brickless.simulation.Stimulus;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;

/** One run that is watched, from its start to a restart or the end of the view. Owned by the driver. */
final class Session {
    private static final Duration SPARE = Duration.ofSeconds(2);

    private final int number;
    private final RunSource.Prepared prepared;
    private final Tap tap = new Tap();
    private final Run run;
    private final Touches touches;
    private final Holds holds = new Holds();
    private boolean closed;
    private boolean begun;

    /** Builds the run; it stands still before its first instruction. */
    Session(int number, RunSource.Prepared prepared) {
        this.number = number;
        this.prepared = prepared;
        this.run = new Simulation(prepared.settings()).start(prepared.program(), tap);
        this.touches = new Touches(prepared.settings().stimuli());
    }

    int number() {
        return number;
    }

    RunSource.Prepared prepared() {
        return prepared;
    }

    Tap tap() {
        return tap;
    }

    Run run() {
        return run;
    }

    int touches() {
        return touches.count();
    }

    long nowNanos() {
        return run.time().toNanos();
    }

    boolean ended() {
        return run.ended();
    }

    /** The figures of the run if it has ended by itself or was closed after it had begun. */
    Optional<RunReport> report() {
        return run.ended() && begun ? Optional.of(run.report()) : Optional.empty();
    }

    void advance(long nanos) {
        begun = true;
        run.advance(Duration.ofNanos(nanos));
    }

    /** Does what the words of a stimuli file say, with the coming physics step. */
    void touch(String words) {
        refuseIfEnded();
        for (Stimulus stimulus : touches.read(words, nowNanos() + run.step().toNanos(), run.step().toNanos())) {
            try {
                run.stimulate(stimulus);
            } catch (SetupException e) {
                throw new RefusedException(e.getMessage());
            }
            touches.add(stimulus);
        }
    }

    /** A viewer takes hold of something or lets it go. */
    void hold(Command.Hold hold) {
        refuseIfEnded();
        String other = hold.robot().isEmpty() || hold.robot().equals(run.robot().name()) ? "" : " on " + hold.robot();
        String what = hold.what() + other;
        if (hold.down()) {
            if (!holds.held(what)) {
                touch("hold " + what);
            }
            holds.take(what, hold.viewer());
        } else if (holds.letGo(what, hold.viewer())) {
            touch("release " + what);
        }
    }

    /** A viewer has gone: whatever it held is let go. */
    void letGo(int viewer) {
        for (String what : ended() ? List.<String>of() : holds.heldBy(viewer)) {
            if (holds.letGo(what, viewer)) {
                touch("release " + what);
            }
        }
    }

    void refuseIfEnded() {
        if (ended()) {
            throw new RefusedException("the run has ended; restart it");
        }
    }

    /** The stimuli file that repeats the session so far. */
    String stimuli() {
        return touches.file(prepared.command().apply(limit()));
    }

    /** A time limit that lets the run end where it stands, or by itself if it did. */
    private Duration limit() {
        if (report().isEmpty()) {
            return run.time().compareTo(run.step()) < 0 ? run.step() : run.time();
        }
        Duration end = Duration.ofNanos(run.outcome().timeNanos());
        return run.outcome().kind().equals("time-limit") ? end : Duration.ofSeconds(end.toSeconds()).plus(SPARE);
    }

    /** Ends the run and writes its files; its stimuli beside them if it was touched. */
    void close() {
        if (closed) {
            return;
        }
        closed = true;
        run.close();
        prepared.program().close();
        report().map(RunReport::files).filter(folder -> !folder.isEmpty())
                .ifPresent(folder -> save(Path.of(folder).resolve("stimuli.txt")));
    }

    private void save(Path file) {
        try {
            if (touches.count() > 0) {
                Files.writeString(file, stimuli());
            } else {
                Files.deleteIfExists(file);
            }
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write " + file, e);
        }
    }
}
