package brickless.world.svg;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import brickless.world.DescriptionException;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Wheel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The library's robots have the sizes of what people build from the kits. */
class RobotNumbersTest {
    private static RobotModel robot(String name) throws DescriptionException {
        return SvgRobotReader.read(Shipped.file("sim/robots/" + name + ".svg"));
    }

    private static double track(RobotModel robot) {
        return Math.abs(robot.wheels().get(0).position().y() - robot.wheels().get(1).position().y());
    }

    @Test
    void educatorRollsATyresCircumferencePerTurn() throws DescriptionException {
        for (Wheel wheel : robot("educator").wheels()) {
            assertThat(Math.PI * wheel.diameterMetres()).isCloseTo(0.1759, withinPercentage(0.1));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"educator", "medium-turret", "gripper"})
    void robotsOfTheKitsHaveTheirMassAndTrack(String name) throws DescriptionException {
        RobotModel robot = robot(name);
        assertThat(robot.massKilograms()).isBetween(0.7, 0.9);
        assertThat(track(robot)).isBetween(0.114 - 1e-9, 0.18);
    }
}
