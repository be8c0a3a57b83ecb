package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.program.Program;
import brickless.trace.Sample;
import brickless.trace.TraceEvent;
import brickless.trace.TraceHeader;
import brickless.trace.TraceListener;
import brickless.world.DescriptionException;
import brickless.world.svg.SvgWorldReader;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import programs.robots.KeyWatch;
import programs.robots.RemoteWatch;
import programs.robots.TouchWatch;

/**
 * Stimuli of people who do not know beforehand what they will do: held for an unknown time, given while the run goes
 * on.
 */
class HeldStimuliTest {
    private static final String TWO = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2000 1000'>"
            + "<g data-robot='left' transform='translate(500 500)'/>"
            + "<g data-robot='right' transform='translate(1500 500)'/></svg>";
    private static final Duration STEP = Duration.ofMillis(2);

    private static SimulationSettings.Builder settings(String... stimuli) throws DescriptionException {
        return SimulationSettings.builder(SvgWorldReader.readText("two.svg", TWO)).ideal(true).pressButtons(false)
                .limit(Duration.ofSeconds(6)).stimuli(StimuliReader.readText("stimuli", String.join("\n", stimuli)));
    }

    private static Run run(Class<?> program, String... stimuli) throws DescriptionException {
        Run run = new Simulation(settings(stimuli).build()).start(program);
        run.toEnd();
        return run;
    }

    private static List<String> printed(Run run, int robot) {
        return run.robots().get(robot).printedLines();
    }

    @Test
    void aKeyIsDownFromHoldToRelease() throws DescriptionException {
        assertThat(printed(run(KeyWatch.class, "1s hold key ENTER", "1500ms release key ENTER", "2s press LEFT 100ms",
                "3s press UP 100ms"), 0)).containsExactly("2", "16", "1");
    }

    @Test
    void aTouchSensorIsPressedFromHoldToRelease() throws DescriptionException {
        assertThat(printed(run(TouchWatch.class, "1s hold push S1", "2500ms release push S1", "3s push S1 300ms"), 0))
                .containsExactly("pressed 10", "released 25", "pressed 30", "released 33");
    }

    @Test
    void aRemoteButtonSendsFromHoldToRelease() throws DescriptionException {
        assertThat(printed(run(RemoteWatch.class, "2s hold remote 2 TOP_LEFT", "3s release remote 2 TOP_LEFT",
                "4s remote 2 BEACON 300ms"), 0)).containsExactly("command 1", "command 0", "command 9", "command 0");
    }

    @Test
    void aStimulusConcernsTheRobotThatItNames() throws DescriptionException {
        Run run = run(KeyWatch.class, "1s press ENTER 100ms on right", "2s hold key LEFT on right",
                "3s release key LEFT on right", "4s press UP 100ms");
        assertThat(printed(run, 0)).containsExactly("1");
        assertThat(printed(run, 1)).containsExactly("2", "16");
    }

    @Test
    void aRemoteIsSeenByAllRobotsUnlessItIsPointedAtOne() throws DescriptionException {
        Run run = run(RemoteWatch.class, "2s remote 2 TOP_LEFT 500ms", "3s remote 2 BEACON 300ms on right");
        assertThat(printed(run, 0)).containsExactly("command 1", "command 0");
        assertThat(printed(run, 1)).containsExactly("command 1", "command 0", "command 9", "command 0");
    }

    @Test
    void theTraceNamesTheRobotThatAStimulusConcerns() throws DescriptionException {
        Collected trace = new Collected();
        Run run = new Simulation(settings("1s press ENTER 100ms on right", "2s clap 60dB").build())
                .start(Program.onClassPath(KeyWatch.class.getName()), trace);
        run.toEnd();
        assertThat(trace.stimuli).containsExactly("1000 right press ENTER 100ms on right", "2000 left clap 60dB");
    }

    @Test
    void aRobotThatIsNotThereIsRefused() {
        assertThatThrownBy(() -> run(KeyWatch.class, "1s press ENTER 100ms on roof")).isInstanceOf(SetupException.class)
                .hasMessageContaining("no robot named roof").hasMessageContaining("left, right");
    }

    /** Planned beforehand or given at the last moment, at the same instants: the same trace. */
    @Test
    void stimuliGivenWhileTheRunGoesOnGiveTheTraceOfPlannedOnes() throws DescriptionException {
        String[] lines = {
            "2ms hold key ENTER", "500ms push S1 500ms", "700ms hold remote 2 TOP_LEFT", "1s release key ENTER",
            "1s push S1 200ms", "1s press LEFT 100ms on right", "1100ms press LEFT 100ms on right",
            "2s move left 600,400 45", "2s move left 610,400 45", "2600ms release remote 2 TOP_LEFT",
            "3s battery 7.1V on right"
        };
        Run planned = run(TouchWatch.class, lines);
        Run live = new Simulation(settings().build()).start(TouchWatch.class);
        for (String line : lines) {
            Stimulus stimulus = StimuliReader.readText("live", line).get(0);
            Duration before = Duration.ofNanos(stimulus.atNanos()).minus(STEP);
            if (before.compareTo(live.time()) > 0) {
                live.advance(before.minus(live.time()));
            }
            live.stimulate(stimulus);
        }
        live.toEnd();
        assertThat(live.report().traceHash()).isEqualTo(planned.report().traceHash());
    }

    @Test
    void aKeyHeldByHandWasNotPlannedForAutomaticPresses() throws DescriptionException {
        Run planned = new Simulation(settings("4s hold key LEFT", "5s release key LEFT").pressButtons(true).build())
                .start(KeyWatch.class);
        planned.toEnd();
        Run live = new Simulation(settings().pressButtons(true).build()).start(KeyWatch.class);
        for (String line : new String[] {"4s hold key LEFT", "5s release key LEFT"}) {
            Stimulus stimulus = StimuliReader.readText("live", line).get(0);
            live.advance(Duration.ofNanos(stimulus.atNanos()).minus(STEP).minus(live.time()));
            live.stimulate(stimulus);
        }
        live.toEnd();
        assertThat(live.report().traceHash()).isEqualTo(planned.report().traceHash());
        assertThat(printed(live, 0)).startsWith("2");
    }

    @Test
    void aRunThatIsClosedHasTheTraceOfOneWithThatLimit() throws DescriptionException {
        for (long millis : new long[] {2, 50, 1_234, 2_000}) {
            Run limited = new Simulation(settings().limit(Duration.ofMillis(millis)).build()).start(TouchWatch.class);
            limited.toEnd();
            Run closed = new Simulation(settings().limit(Duration.ofNanos(Long.MAX_VALUE)).build())
                    .start(TouchWatch.class);
            closed.advance(Duration.ofMillis(millis));
            closed.close();
            assertThat(closed.report().traceHash()).as("after %d ms", millis).isEqualTo(limited.report().traceHash());
        }
    }

    @Test
    void advancingByNothingReturnsAtOnce() throws DescriptionException {
        try (Run run = new Simulation(settings().build()).start(TouchWatch.class)) {
            run.advance(Duration.ofSeconds(1));
            run.advance(Duration.ZERO);
            assertThat(run.time()).isEqualTo(Duration.ofSeconds(1));
        }
    }

    /** The stimuli of a trace as text. */
    private static final class Collected implements TraceListener {
        private final List<String> stimuli = new ArrayList<>();

        @Override
        public void header(TraceHeader header) {
            assertThat(header.world()).isEqualTo("two");
        }

        @Override
        public void sample(Sample sample) {
            assertThat(sample.robots()).hasSize(2);
        }

        @Override
        public void event(long timeNanos, String robot, TraceEvent event) {
            if (event instanceof TraceEvent.StimulusEvent stimulus) {
                stimuli.add(timeNanos / 1_000_000 + " " + robot + " " + stimulus.text());
            }
        }
    }
}
