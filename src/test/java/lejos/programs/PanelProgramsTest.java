package lejos.programs;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.TestWorlds;
import brickless.simulation.Run;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import brickless.simulation.Stimulus;
import java.io.OutputStream;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Whole programs with several threads on a simulated brick. */
class PanelProgramsTest {
    private static final long MILLI = 1_000_000;

    private static Run run(Class<?> program, Stimulus... stimuli) {
        SimulationSettings settings = SimulationSettings.builder(TestWorlds.with()).robot(TestWorlds.educator())
                .limit(Duration.ofSeconds(40)).console(OutputStream.nullOutputStream()).stimuli(List.of(stimuli))
                        .build();
        Run run = new Simulation(settings).start(program);
        run.toEnd();
        return run;
    }

    private static Stimulus press(long atMillis, int keyMask, long forMillis) {
        return new Stimulus.Press(atMillis * MILLI, keyMask, forMillis * MILLI, "press");
    }

    @Test
    void allListenersOfAKeyHearItInTheOrderOfTheirRegistration() {
        try (Run run = run(Listening.class, press(500, 2, 400), press(1500, 32, 300))) {
            assertThat(run.robot().printedLines()).containsExactly("first Enter down", "second Enter down",
                    "first Enter up", "second Enter up", "escape Escape down", "escape Escape up");
            assertThat(run.outcome().kind()).isEqualTo("exited");
        }
    }

    @Test
    void veryShortPressesArriveAsTwoReleases() {
        try (Run run = run(Listening.class, press(500, 2, 60), press(1500, 32, 300))) {
            assertThat(run.robot().printedLines().subList(0, 4)).containsExactly("first Enter up", "second Enter up",
                    "first Enter up", "second Enter up");
        }
    }

    @Test
    void timersFireOncePerRoundAndOnceMoreAfterTheirStop() {
        try (Run run = run(Ticking.class)) {
            assertThat(run.robot().printedLines())
                    .containsExactly("start", "7", "9", "11", "stop", "13", "again", "25");
        }
    }

    @Test
    void anUncaughtExceptionEndsItsThreadOnly() {
        try (Run run = run(Crashing.class)) {
            assertThat(run.robot().printedLines()).containsExactly("main went on");
            assertThat(run.robot().screenText()).isEqualTo("main went on\n\n\nalive");
            assertThat(run.outcome().kind()).isEqualTo("failed");
        }
    }

    @Test
    void programsThatAskForKeysGetThem() {
        try (Run run = run(Asking.class)) {
            List<String> lines = run.robot().printedLines();
            assertThat(lines.get(0)).isEqualTo("key 2");
            assertThat(lines.get(1)).startsWith("menu ");
            assertThat(lines.get(2)).startsWith("done ");
        }
    }

    @Test
    void downWithEnterEndsTheProgram() {
        try (Run run = run(Listening.class, press(500, 6, 500))) {
            assertThat(run.ended()).isTrue();
            assertThat(run.time()).isBetween(Duration.ofMillis(600), Duration.ofMillis(900));
        }
    }
}
