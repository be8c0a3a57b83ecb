package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import brickless.world.DescriptionException;
import brickless.world.svg.SvgWorldReader;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import programs.robots.DistanceWatch;
import programs.robots.KeyWatch;
import programs.robots.RemoteWatch;
import programs.robots.SoundWatch;
import programs.robots.TouchWatch;
import programs.robots.VoltageWatch;

/** Every kind of stimulus reaches the program. */
class StimuliTest {
    private static final String WORLD = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 4000 1000'>"
            + "<rect id='near' data-solid='movable' data-mass-kg='2' data-height-mm='200' x='1000' y='300' "
            + "width='100' height='400'/>"
            + "<rect id='far' data-solid='fixed' data-height-mm='200' x='2000' y='0' width='100' height='1000'/>"
            + "<g data-robot='robot' transform='translate(500 500)'/></svg>";

    private static Run run(Class<?> program, String... stimuli) throws DescriptionException {
        Run run = new Simulation(SimulationSettings.builder(SvgWorldReader.readText("test.svg", WORLD)).ideal(true)
                .pressButtons(false)
                .limit(Duration.ofSeconds(15)).stimuli(StimuliReader.readText("stimuli", String.join("\n", stimuli)))
                .build()).start(program);
        run.toEnd();
        assertThat(run.outcome().kind()).isEqualTo("exited");
        return run;
    }

    private static List<String> printed(Class<?> program, String... stimuli) throws DescriptionException {
        return run(program, stimuli).robot().printedLines();
    }

    @Test
    void pressHoldsAKey() throws DescriptionException {
        assertThat(printed(KeyWatch.class, "1s press ENTER 200ms", "2s press LEFT 200ms", "3s press UP 200ms"))
                .containsExactly("2", "16", "1");
    }

    @Test
    void pushHoldsTheTouchSensor() throws DescriptionException {
        List<String> lines = printed(TouchWatch.class, "1s push S1 500ms", "3s push S1 300ms");
        assertThat(lines).containsExactly("pressed 10", "released 15", "pressed 30", "released 33");
    }

    @Test
    void remoteSendsOnItsChannelOnly() throws DescriptionException {
        assertThat(printed(RemoteWatch.class, "2s remote 1 TOP_RIGHT 500ms", "3s remote 2 TOP_LEFT 500ms",
                "4s remote 2 BEACON 300ms"))
                .containsExactly("command 1", "command 0", "command 9", "command 0");
    }

    @Test
    void clapIsHeardForAMoment() throws DescriptionException {
        assertThat(printed(SoundWatch.class, "1s clap 90dB", "2s clap 10dB")).containsExactly("loud", "quiet");
    }

    @Test
    void batteryChangesTheVoltage() throws DescriptionException {
        List<String> tenths = printed(VoltageWatch.class, "500ms battery 6.9V", "1500ms battery 8.0V");
        assertThat(tenths).hasSize(3);
        assertThat(Integer.parseInt(tenths.get(1))).as("with what the brick itself draws").isCloseTo(69, within(2));
        assertThat(Integer.parseInt(tenths.get(2))).isCloseTo(80, within(2));
    }

    @Test
    void removeTakesAnObstacleAway() throws DescriptionException {
        List<String> centimetres = printed(DistanceWatch.class, "1500ms remove near");
        int before = Integer.parseInt(centimetres.get(0));
        assertThat(Integer.parseInt(centimetres.get(3))).isCloseTo(before + 100, within(2));
    }

    @Test
    void moveMovesAnObstacle() throws DescriptionException {
        List<String> centimetres = printed(DistanceWatch.class, "1500ms move near 1250,500 0");
        assertThat(Integer.parseInt(centimetres.get(3))).as("the middle of the box was at 1050")
                .isCloseTo(Integer.parseInt(centimetres.get(0)) + 20,
                within(2));
    }

    @Test
    void moveMovesTheRobot() throws DescriptionException {
        Run run = run(DistanceWatch.class, "1s move robot 700,400 90");
        assertThat(run.robot().xMetres()).isCloseTo(0.7, within(1e-3));
        assertThat(run.robot().yMetres()).isCloseTo(0.4, within(1e-3));
        assertThat(run.robot().headingDegrees()).isCloseTo(90, within(0.1));
        assertThat(run.robot().distanceMetres()).as("was not driven").isCloseTo(0, within(1e-3));
    }

    @Test
    void keysPressedFromATestArrive() throws DescriptionException {
        Run run = new Simulation(SimulationSettings.builder(SvgWorldReader.readText("test.svg", WORLD))
                .pressButtons(false).build()).start(KeyWatch.class);
        for (String key : new String[] {"RIGHT", "ESCAPE", "down"}) {
            run.advance(Duration.ofSeconds(1));
            run.press(key);
        }
        run.advance(Duration.ofSeconds(2));
        assertThat(run.robot().printedLines()).containsExactly("8", "32", "4");
        assertThat(run.ended()).isTrue();
    }

    @Test
    void aStimulusForNothingIsRefusedWhereItIsGiven() throws DescriptionException {
        try (Run run = new Simulation(SimulationSettings.builder(SvgWorldReader.readText("test.svg", WORLD)).build())
                .start(KeyWatch.class)) {
            run.advance(Duration.ofSeconds(1));
            Stimulus remove = StimuliReader.readText("stimuli", "2s remove piano").get(0);
            assertThatThrownBy(() -> run.stimulate(remove)).isInstanceOf(SetupException.class)
                    .hasMessageContaining("piano").hasMessageContaining("near");
            assertThatThrownBy(() -> run.press("SPACE")).isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("ENTER");
        }
    }
}
