package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.TestWorlds;
import brickless.physics.ArenaSettings;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A bumper is pressed by force, not by being near: 0.3 N, what a crate of 61 g slides with. */
class TouchForceTest {
    private static final double PRESSED_VOLTS = 2.5;

    @ParameterizedTest
    @CsvSource({"0.01,false", "0.02,false", "0.03,false", "0.08,true", "0.2,true", "1,true"})
    void crateThatSlidesAwayLightlyDoesNotPressTheBumper(double kilograms, boolean pressed) {
        SensorMount bumper = new SensorMount("bumper", 0, SensorType.EV3_TOUCH, new Point2(0.06, 0), 0, 0.03,
                TestWorlds.box(0.05, -0.05, 0.06, 0.05), Optional.empty());
        RobotBench bench = new RobotBench(TestWorlds.world(List.of(TestWorlds.crate("crate", 0.12, 0, 0.1, kilograms)),
                List.of()), TestWorlds.educator(bumper), new Pose2(0, 0, 0), ArenaSettings.of(false));
        bench.rotate(60, 60, 20);
        assertThat(bench.arena.obstacles().get(0).displaced()).isTrue();
        assertThat(bench.devices.sensor(0).analog().pin6Volts() > PRESSED_VOLTS).isEqualTo(pressed);
    }
}
