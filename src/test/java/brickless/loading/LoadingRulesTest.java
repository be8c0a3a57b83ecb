package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.loading.LoadingRules.Treatment;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which rule decides for which class. */
class LoadingRulesTest {
    @ParameterizedTest
    @CsvSource({
        "java.lang.String, SHARED",
        "javax.swing.JFrame, SHARED",
        "org.w3c.dom.Node, SHARED",
        "org.slf4j.Logger, SHARED",
        "org.junit.jupiter.api.Assertions, SHARED",
        "brickless.kernel.Kernel, SHARED",
        "brickless.hardware.MotorSocket, SHARED",
        "brickless.kernel.hooks.VirtualMachine, SHARED",
        "brickless.kernel.hooks.FloatingText$Reading, SHARED",
        "brickless.kernel.hooks.Hooks, PER_ROBOT_PLAIN",
        "brickless.kernel.hooks.RobotState, PER_ROBOT_PLAIN",
        "brickless.hardware.BrickAccess, PER_ROBOT_PLAIN",
        "brickless.concurrent.Semaphore, PER_ROBOT_REWRITTEN",
        "lejos.hardware.motor.Motor, PER_ROBOT_REWRITTEN",
        "Main, PER_ROBOT_REWRITTEN",
        "org.example.Main, PER_ROBOT_REWRITTEN",
        "javafx.Main, PER_ROBOT_REWRITTEN"})
    void theFirstFittingRuleDecides(String name, Treatment treatment) {
        assertThat(LoadingRules.standard().of(name)).isEqualTo(treatment);
    }

    @ParameterizedTest
    @CsvSource({"brickless.loading.fixtures.Calls, PER_ROBOT_REWRITTEN", "brickless.loading.RobotClassLoader, SHARED"})
    void anAddedRuleComesFirst(String name, Treatment treatment) {
        assertThat(LoadingRules.standard().rewriting("brickless.loading.fixtures.").of(name)).isEqualTo(treatment);
    }
}
