package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.world.DescriptionException;
import brickless.world.Pose2;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StimuliReaderTest {
    private static Stimulus only(String line) throws DescriptionException {
        return StimuliReader.readText("s.txt", line).get(0);
    }

    @Test
    void everyKindOfStimulusIsUnderstood() throws DescriptionException {
        assertThat(only("2.0s  press ENTER 200ms"))
                .isEqualTo(new Stimulus.Press(2_000_000_000L, 2, 200_000_000L, "press ENTER 200ms"));
        assertThat(only("5s push S1 300ms # by hand"))
                .isEqualTo(new Stimulus.Push(5_000_000_000L, 0, 300_000_000L, "push S1 300ms"));
        assertThat(only("6s remote 1 TOP_LEFT 500ms"))
                .isEqualTo(new Stimulus.Remote(6_000_000_000L, 1, 1, 500_000_000L, "remote 1 TOP_LEFT 500ms"));
        assertThat(only("8s clap 80dB")).isEqualTo(new Stimulus.Clap(8_000_000_000L, 80, "clap 80dB"));
        assertThat(only("9s move robot 500,300 90"))
                .isEqualTo(new Stimulus.Move(9_000_000_000L, "robot", new Pose2(0.5, 0.3, StrictMath.PI / 2),
                        "move robot 500,300 90"));
        assertThat(only("10s remove crate1"))
                .isEqualTo(new Stimulus.Remove(10_000_000_000L, "crate1", "remove crate1"));
        assertThat(only("12s battery 6.9V")).isEqualTo(new Stimulus.Battery(12_000_000_000L, 6.9, "battery 6.9V"));
    }

    @Test
    void whatIsHeldForAnUnknownTimeHasTwoLines() throws DescriptionException {
        assertThat(only("1s hold key ENTER"))
                .isEqualTo(new Stimulus.Hold(1_000_000_000L, new Stimulus.Key(2), "hold key ENTER"));
        assertThat(only("2s release push S4"))
                .isEqualTo(new Stimulus.Release(2_000_000_000L, new Stimulus.TouchSensor(3), "release push S4"));
        assertThat(only("3s hold remote 2 BEACON"))
                .isEqualTo(new Stimulus.Hold(3_000_000_000L, new Stimulus.RemoteButton(2, 9), "hold remote 2 BEACON"));
    }

    @Test
    void aStimulusCanNameItsRobot() throws DescriptionException {
        Stimulus stimulus = only("1s press ENTER 200ms on yellow");
        assertThat(stimulus).isEqualTo(
                new Stimulus.On("yellow", new Stimulus.Press(1_000_000_000L, 2, 200_000_000L, "press ENTER 200ms")));
        assertThat(stimulus.text()).isEqualTo("press ENTER 200ms on yellow");
        assertThat(stimulus.atNanos()).isEqualTo(1_000_000_000L);
    }

    @Test
    void linesAreSortedByTimeAndCommentsSkipped() throws DescriptionException {
        assertThat(StimuliReader.readText("s", "# first\n\n3s clap 70dB\n1s press UP 1s\n"))
                .extracting(Stimulus::atNanos).containsExactly(1_000_000_000L, 3_000_000_000L);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "soon press ENTER 1s | 'soon' is no duration",
        "1s | nothing to do at 1s",
        "1s press HOME 1s | unknown key 'HOME'; allowed: UP, ENTER, DOWN, RIGHT, LEFT, ESCAPE",
        "1s press ENTER | 'press' takes 2 words, found 1",
        "1s push S5 1s | 'S5' is no sensor port; allowed: S1 to S4",
        "1s remote 5 BEACON 1s | '5' is no infrared channel",
        "1s clap loud | 'loud' is not a level like 80dB",
        "1s move robot here 90 | 'here 90' is not X,Y DEGREES",
        "1s hold ENTER | 'hold' needs what to hold",
        "1s release | 'release' needs what to release",
        "1s hold key ENTER 1s | 'hold' takes 2 words, found 3",
        "1s hold push S5 | 'S5' is no sensor port",
        "1s move robot 1234567,0 0 | '1234567,0 0' is not X,Y DEGREES",
        "1s dance | unknown stimulus 'dance'"})
    void badLinesAreLocated(String line, String message) {
        assertThatThrownBy(() -> StimuliReader.readText("party.txt", "# one\n" + line))
                .isInstanceOf(DescriptionException.class).hasMessageStartingWith("party.txt:2: " + message);
    }

    @Test
    void aMissingFileIsNamed() {
        assertThatThrownBy(() -> StimuliReader.read(Path.of("no/such.txt"))).isInstanceOf(DescriptionException.class)
                .hasMessageContaining("such.txt: cannot be read");
    }
}
