package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.world.DescriptionException;
import brickless.world.Rgb;
import brickless.world.svg.SvgRobotReader;
import brickless.world.svg.SvgWorldReader;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import programs.robots.ManyEyes;
import programs.robots.TwoPollers;

/** Frames show what sensors see, and looking at them changes nothing. */
class FrameTest {
    /** A wall 500 mm ahead of the eyes at x = 550, on a floor painted with one colour. */
    private static final String WORLD = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2000 1000'>"
            + "<rect width='2000' height='1000' fill='rgb(200,40,10)'/>"
            + "<rect data-solid='fixed' data-height-mm='300' fill='white' x='1050' y='0' width='100' height='1000'/>"
            + "<rect id='box' data-solid='movable' data-mass-kg='0.5' x='300' y='100' width='100' height='100'/>"
            + "<g data-robot='robot' transform='translate(500 500)'/></svg>";
    private static final String ROBOT = "<svg xmlns='http://www.w3.org/2000/svg'>"
            + "<rect data-part='chassis' x='-100' y='-50' width='150' height='100' data-mass-kg='1'/>"
            + "<circle data-part='caster' id='ball' cx='-80' cy='0' r='8'/>"
            + "<rect data-part='wheel' id='left' data-port='B' data-motor='large' x='-28' y='-70' width='56' "
            + "height='26' data-diameter-mm='56'/>"
            + "<rect data-part='wheel' id='right' data-port='C' data-motor='large' x='-28' y='44' width='56' "
            + "height='26' data-diameter-mm='56'/>"
            + "<circle data-part='sensor' id='down' data-port='S1' data-sensor='ev3-color' cx='40' cy='0' r='5' "
            + "data-height-mm='8'/>"
            + "<g data-part='sensor' id='heat' data-port='S2' data-sensor='ev3-infrared' data-height-mm='50' "
            + "transform='translate(50 20)'><rect x='-10' y='-5' width='10' height='10'/></g>"
            + "<g data-part='sensor' id='ears' data-port='S4' data-sensor='ev3-ultrasonic' data-height-mm='50' "
            + "transform='translate(50 -20)'><rect x='-10' y='-5' width='10' height='10'/></g>"
            + "<g data-part='turret' id='mast' data-port='A' data-motor='medium' transform='translate(-60 0)'/></svg>";

    private static SimulationSettings.Builder settings() throws DescriptionException {
        return SimulationSettings.builder(SvgWorldReader.readText("test.svg", WORLD))
                .robot(SvgRobotReader.readText("robot.svg", ROBOT)).ideal(true);
    }

    private static Frame.RobotFrame seen() throws DescriptionException {
        try (Run run = new Simulation(settings().build()).start(ManyEyes.class)) {
            run.advance(Duration.ofSeconds(3));
            return run.frame().robots().get(0);
        }
    }

    private static Frame.Beam beam(String kind) throws DescriptionException {
        return seen().beams().stream().filter(beam -> beam.kind().equals(kind)).findFirst().orElseThrow();
    }

    @Test
    void anUltrasonicBeamEndsAtTheWallItHears() throws DescriptionException {
        Frame.Beam beam = beam("ev3-ultrasonic");
        assertThat(beam.port()).isEqualTo(4);
        assertThat(beam.ends()).hasSize(9).allSatisfy(end -> assertThat(end.x()).isCloseTo(1.05, within(1e-3)));
        assertThat(beam.from().y()).isCloseTo(0.48, within(0.01));
        assertThat(beam.metres()).isCloseTo(1.05 - beam.from().x(), within(2e-3));
        assertThat(beam.ends().get(8).y() - beam.ends().get(0).y()).as("15 degrees to each side")
                .isCloseTo(2 * (1.05 - beam.from().x()) * Math.tan(Math.toRadians(15)), within(1e-3));
    }

    @Test
    void anInfraredBeamEndsAtTheWallItSees() throws DescriptionException {
        Frame.Beam beam = beam("ev3-infrared");
        assertThat(beam.port()).isEqualTo(2);
        assertThat(beam.ends()).hasSize(5).allSatisfy(end -> assertThat(end.x()).isCloseTo(1.05, within(1e-3)));
        assertThat(beam.metres()).as("told in percent of 70 cm").isCloseTo(1.05 - beam.from().x(), within(0.007));
    }

    @Test
    void aColourSpotHasTheColourOfTheFloor() throws DescriptionException {
        Frame.Spot spot = seen().spots().get(0);
        assertThat(spot.port()).isEqualTo(1);
        assertThat(spot.at().x()).isCloseTo(0.54, within(1e-3));
        assertThat(spot.at().y()).isCloseTo(0.5, within(1e-3));
        assertThat(spot.radiusMetres()).isEqualTo(0.005);
        assertThat(spot.colour()).contains(new Rgb(200, 40, 10));
    }

    @Test
    void sensorsThatNobodyReadSeeNothing() throws DescriptionException {
        try (Run run = new Simulation(settings().build()).start(ManyEyes.class)) {
            Frame.RobotFrame robot = run.frame().robots().get(0);
            assertThat(robot.beams()).isEmpty();
            assertThat(robot.spots()).allSatisfy(spot -> assertThat(spot.colour()).isEmpty());
            assertThat(robot.parts()).extracting(Frame.Part::id).containsExactly("mast");
        }
    }

    @Test
    void bodiesAreThereOnceTheyMoved() throws DescriptionException {
        try (Run run = new Simulation(settings().stimuli(StimuliReader.readText("s", "10ms move box 400,300 90"))
                .build()).start(ManyEyes.class)) {
            assertThat(run.frame().bodies()).isEmpty();
            run.advance(Duration.ofMillis(20));
            assertThat(run.frame().bodies()).extracting(body -> body.id()).containsExactly("box");
            assertThat(run.frame().timeNanos()).isEqualTo(20_000_000);
        }
    }

    @Test
    void lookingChangesNothing() throws DescriptionException {
        for (Class<?> program : new Class<?>[] {ManyEyes.class, TwoPollers.class}) {
            SimulationSettings noisy = settings().ideal(false).limit(Duration.ofSeconds(3)).build();
            Run alone = new Simulation(noisy).start(program);
            alone.toEnd();
            Run watched = new Simulation(noisy).start(program);
            while (!watched.ended()) {
                watched.frame();
                watched.advance(Duration.ofMillis(33));
            }
            assertThat(watched.report().traceHash()).isEqualTo(alone.report().traceHash());
        }
    }
}
