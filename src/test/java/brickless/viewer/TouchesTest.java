package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.simulation.StimuliReader;
import brickless.simulation.Stimulus;
import brickless.world.DescriptionException;
import java.util.List;
import org.junit.jupiter.api.Test;

class TouchesTest {
    private static final long MILLI = 1_000_000;
    private static final long STEP = 2 * MILLI;

    private static List<Stimulus> read(String words) {
        return new Touches(List.of()).read(words, 1_002 * MILLI, STEP);
    }

    @Test
    void wordsMeanWhatTheyMeanInAStimuliFile() throws DescriptionException {
        for (String words : List.of("clap 80dB", "move robot 500,300.5 -90", "remove crate", "battery 6.9V on two",
                "push S1 300ms", "hold key ENTER", "release remote 1 TOP_LEFT on two")) {
            assertThat(read(words)).isEqualTo(StimuliReader.readText("file", "1002ms " + words));
        }
    }

    @Test
    void aPressIsHeldAndReleasedAfterItsDurationInSteps() {
        Stimulus.Key enter = new Stimulus.Key(2);
        assertThat(read("press ENTER 99ms")).containsExactly(new Stimulus.Hold(1_002 * MILLI, enter, "hold key ENTER"),
                new Stimulus.Release(1_100 * MILLI, enter, "release key ENTER"));
        assertThat(read("press enter 1ms on two")).containsExactly(
                new Stimulus.On("two", new Stimulus.Hold(1_002 * MILLI, enter, "hold key enter")),
                new Stimulus.On("two", new Stimulus.Release(1_004 * MILLI, enter, "release key enter")));
    }

    @Test
    void theFileHoldsWhatWasPlannedAndWhatWasTouchedInOrderOfTime() throws DescriptionException {
        Touches touches = new Touches(StimuliReader.readText("planned", "500ms clap 50dB\n2s clap 60dB"));
        touches.read("press UP 20ms", 100 * MILLI, STEP).forEach(touches::add);
        touches.read("clap 70dB", 500 * MILLI, STEP).forEach(touches::add);
        assertThat(touches.count()).isEqualTo(3);
        String file = touches.file("brickless run X --stimuli stimuli.txt");
        assertThat(file.lines().skip(1))
                .containsExactly("# brickless run X --stimuli stimuli.txt", "100ms hold key UP", "120ms release key UP",
                "500ms clap 50dB", "500ms clap 70dB", "2000ms clap 60dB");
        assertThat(StimuliReader.readText("saved", file)).hasSize(5);
    }

    @Test
    void timesAreKeptExactly() throws DescriptionException {
        Touches touches = new Touches(StimuliReader.readText("planned", "0.000000001s clap 50dB"));
        assertThat(touches.file("x")).contains("\n0.000000001s clap 50dB\n");
    }

    @Test
    void linesWithinWordsAreRefused() {
        for (String words : List.of("", "clap 80dB\n1s clap 80dB", "clap 80dB\r1s clap 80dB",
                "clap 80dB\u20281s clap 80dB", "# comment", "clap 80dB # loud", "x".repeat(201))) {
            assertThatThrownBy(() -> read(words)).as(words).isInstanceOf(RefusedException.class);
        }
    }

    @Test
    void aThingIsHeldFromTheFirstHandToTheLast() {
        Holds holds = new Holds();
        holds.take("key ENTER", 1);
        holds.take("key ENTER", 2);
        holds.take("push S1", 1);
        assertThat(holds.held("key ENTER")).isTrue();
        assertThat(holds.heldBy(1)).containsExactly("key ENTER", "push S1");
        assertThat(holds.letGo("key ENTER", 1)).isFalse();
        assertThat(holds.letGo("key ENTER", 1)).isFalse();
        assertThat(holds.letGo("key ENTER", 2)).isTrue();
        assertThat(holds.held("key ENTER")).isFalse();
        assertThat(holds.letGo("key ENTER", 2)).isFalse();
    }
}
