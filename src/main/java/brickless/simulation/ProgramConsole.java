package brickless.simulation;

import brickless.hardware.ProgramLog;
import brickless.trace.TraceEvent;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.function.LongSupplier;

/**
 * What one robot's program prints, fails with and decides, on its way into the record of the run. Used by the running
 * fibre only.
 */
final class ProgramConsole implements ProgramLog {
    private record Arbitration(List<String> names, BehaviourChanges wanted, BehaviourChanges active) {}

    private final String robot;
    private final Recorder recorder;
    private final OutputStream echo;
    private final LongSupplier clock;
    private final IntConsumer exit;
    private final ByteArrayOutputStream[] lines = {new ByteArrayOutputStream(), new ByteArrayOutputStream()};
    private final List<String> complete = new ArrayList<>();
    private final List<Arbitration> arbitrators = new ArrayList<>();
    private String failure;

    ProgramConsole(String robot, Recorder recorder, OutputStream echo, LongSupplier clock, IntConsumer exit) {
        this.robot = robot;
        this.recorder = recorder;
        this.echo = echo;
        this.clock = clock;
        this.exit = exit;
    }

    @Override
    public void printed(byte[] bytes, int offset, int length, boolean error) {
        recorder.console(bytes, offset, length);
        try {
            echo.write(bytes, offset, length);
            echo.flush();
        } catch (IOException e) {
            throw new UncheckedIOException("cannot pass the program's output on", e);
        }
        ByteArrayOutputStream line = lines[error ? 1 : 0];
        for (int i = offset; i < offset + length; i++) {
            if (bytes[i] == '\n') {
                flush(error);
            } else {
                line.write(bytes[i]);
            }
        }
    }

    private void flush(boolean error) {
        ByteArrayOutputStream line = lines[error ? 1 : 0];
        String text = line.toString(StandardCharsets.UTF_8);
        complete.add(text);
        event(new TraceEvent.PrintEvent(text, error));
        line.reset();
    }

    /** Complete lines printed so far, to either stream. */
    List<String> lines() {
        return List.copyOf(complete);
    }

    /** Records text that the program printed without ending the line. */
    void finish() {
        for (int i = 0; i < lines.length; i++) {
            if (lines[i].size() > 0) {
                flush(i == 1);
            }
        }
    }

    @Override
    public void uncaught(Thread thread, Throwable exception) {
        event(new TraceEvent.ExceptionEvent(thread.getName(), exception.toString()));
        if (failure == null) {
            failure = ProgramFailure.describe(thread.getName(), exception, clock.getAsLong());
        }
    }

    /** The first uncaught exception, described. */
    Optional<String> failure() {
        return Optional.ofNullable(failure);
    }

    /** Class name of the behaviour that the (last) arbitrator runs now. */
    Optional<String> activeBehaviour() {
        return arbitrators.stream().filter(a -> a.active().current() >= 0)
                .map(a -> a.names().get(a.active().current())).reduce((a, b) -> b);
    }

    @Override
    public int arbitratorCreated(String[] behaviours) {
        int number = arbitrators.size();
        event(new TraceEvent.ArbitratorEvent(number, List.of(behaviours)));
        arbitrators.add(new Arbitration(List.of(behaviours), changes("wants", number), changes("active", number)));
        return number;
    }

    private BehaviourChanges changes(String kind, int arbitrator) {
        return new BehaviourChanges((time, behaviour) -> recorder.event(time, robot,
                new TraceEvent.BehaviourEvent(kind, arbitrator, behaviour)));
    }

    @Override
    public void behaviourWanted(int arbitrator, int behaviour) {
        arbitrators.get(arbitrator).wanted().set(clock.getAsLong(), behaviour);
    }

    @Override
    public void behaviourActive(int arbitrator, int behaviour) {
        arbitrators.get(arbitrator).active().set(clock.getAsLong(), behaviour);
    }

    /** To be called at every physics step. */
    void step(long nowNanos) {
        for (int i = 0; i < arbitrators.size(); i++) {
            arbitrators.get(i).wanted().step(nowNanos);
            arbitrators.get(i).active().step(nowNanos);
        }
    }

    @Override
    public void behaviourSuppressed(int arbitrator, int behaviour) {
        event(new TraceEvent.BehaviourEvent("suppressed", arbitrator, behaviour));
        arbitrators.get(arbitrator).active().awaitEnd();
    }

    @Override
    public void endProgram(int status) {
        exit.accept(status);
    }

    private void event(TraceEvent event) {
        recorder.event(clock.getAsLong(), robot, event);
    }
}
