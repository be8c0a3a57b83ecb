package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.simulation.RobotView;
import brickless.simulation.Run;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.function.UnaryOperator;
import kit.Crash;
import kit.Follower;
import kit.Layers;
import kit.Leaves;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Layers of the screen, exceptions, and the ways a program ends. */
class LifeCycleTest {
    private static Run start(Class<?> program, UnaryOperator<SimulationSettings.Builder> settings) {
        SimulationSettings.Builder builder = SimulationSettings.builder(Kit.worldOf(Kit.EMPTY))
                .robot(Kit.robotOf(Kit.BENCH))
                .limit(Duration.ofSeconds(20)).pressButtons(false);
        return new Simulation(settings.apply(builder).build()).start(program);
    }

    private static String screenAt(Run run, int millis) {
        run.advance(Duration.ofMillis(millis).minus(run.time()));
        return run.robot().screenText();
    }

    @Test
    void clearingTheScreenLeavesPrintedText() {
        try (Run run = start(Layers.class, UnaryOperator.identity())) {
            assertThat(screenAt(run, 900)).isEqualTo("printed\n\n\ndrawn");
            assertThat(screenAt(run, 1900)).isEqualTo("printed");
            assertThat(screenAt(run, 2900)).isEqualTo("printed\n\n\ndrawn again");
        }
    }

    @Test
    void leftWithRightShowsOneLayerAfterTheOtherThenAll() {
        try (Run run = start(Layers.class, Kit.stimuli("3s press LEFT 400ms", "3s press RIGHT 400ms",
                "6s press LEFT 400ms",
                "6s press RIGHT 400ms", "9s press LEFT 400ms", "9s press RIGHT 400ms", "12s press LEFT 400ms",
                "12s press RIGHT 400ms", "15s press LEFT 400ms", "15s press RIGHT 400ms"))) {
            assertThat(screenAt(run, 5900)).isEqualTo("\n\n\ndrawn again");
            assertThat(screenAt(run, 8900)).isEqualTo("printed");
            assertThat(screenAt(run, 11_900)).as("exceptions").isEmpty();
            assertThat(screenAt(run, 14_900)).as("system").isEmpty();
            assertThat(screenAt(run, 17_900)).isEqualTo("printed\n\n\ndrawn again");
        }
    }

    @Test
    void downWithEnterEndsTheProgramWithinAFifthOfASecond() {
        try (Run run = start(Layers.class, Kit.stimuli("3s press DOWN 400ms", "3s press ENTER 400ms"))) {
            run.toEnd();
            assertThat(run.outcome().kind()).isEqualTo("exited");
            assertThat(run.time()).isBetween(Duration.ofMillis(3000), Duration.ofMillis(3250));
        }
    }

    @Test
    void escapeAloneEndsNothing() {
        try (Run run = start(Follower.class, Kit.stimuli("1s press ESCAPE 400ms"))) {
            run.toEnd();
            assertThat(run.time()).isGreaterThanOrEqualTo(Duration.ofSeconds(4));
        }
    }

    @Test
    void anExceptionOfMainIsTheLastThingOnTheScreen(@TempDir Path folder) throws IOException {
        try (Run run = start(Crash.class, settings -> settings.out(Optional.of(folder.resolve("run"))))) {
            run.toEnd();
            assertThat(run.outcome().kind()).isEqualTo("failed");
            assertThat(run.outcome().error().orElseThrow()).contains("java.lang.IllegalStateException: arm is jammed",
                    "Caused by: java.lang.IllegalArgumentException: port A", "Crash.java:12");
            assertThat(run.robot().smallScreenText()).startsWith("Uncaught "
                    + "exception\n\njava.lang.IllegalStateExcepti\narm is jammed\n\n"
                    + "by java.lang.IllegalArgumentE\nport A\n\nCrash.main:12");
            assertThat(Files.readAllBytes(folder.resolve("run").resolve("screen.png"))).isEqualTo(run.robot()
                    .screenPng());
        }
    }

    @Test
    void motorsCoastWhenTheProgramIsOver(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("robot.svg"), Kit.BENCH);
        Path world = Files.writeString(folder.resolve("two.svg"), Kit.world(
                "<g data-robot='leaver' data-model='robot.svg' data-program='kit.Leaves' "
                        + "transform='translate(400,400)'/>"
                + "<g data-robot='stayer' data-model='robot.svg' data-program='kit.Follower' "
                        + "transform='translate(400,1600)'/>"));
        SimulationSettings settings = SimulationSettings.builder(Kit.worldOf(Files.readString(world)))
                .worldFile(world.toString()).build();
        try (Run run = new Simulation(settings).start(Leaves.class)) {
            run.advance(Duration.ofMillis(1000));
            RobotView leaver = run.robots().get(0);
            int running = leaver.tachoDegrees('B');
            run.advance(Duration.ofMillis(200));
            int after = leaver.tachoDegrees('B');
            assertThat(after - running).as("coasts on").isBetween(60, 150);
            run.toEnd();
            assertThat(leaver.tachoDegrees('B')).as("and comes to rest").isBetween(after, running + 900);
            assertThat(run.time()).isGreaterThanOrEqualTo(Duration.ofSeconds(4));
        }
    }
}
