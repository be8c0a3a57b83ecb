package brickless.device.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.TestWorlds;
import brickless.device.RobotBench;
import brickless.world.Point2;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Devices that follow the arena do so from the moment they are plugged in until they are taken out. */
class SelfActingSensorsTest {
    private static final long STEP_MILLIS = 2;

    private static final class StepCounter extends RegisterSensor implements SelfActing {
        private int steps;

        StepCounter(SensorSite site) {
            super(site, 1, "V1.0", "NOBODY", "Counter");
        }

        @Override
        public void afterStep(long nowNanos) {
            steps++;
        }

        @Override
        boolean writable(int register) {
            return false;
        }

        @Override
        void written(int register, long nowNanos) {
            throw new AssertionError("nobody writes");
        }

        @Override
        double[] reading(long nowNanos) {
            return new double[] {steps};
        }
    }

    private final RobotBench bench = RobotBench.real(TestWorlds.with(), TestWorlds.educator());

    private StepCounter plug(int port) {
        SensorMount mount = new SensorMount("counter", port, SensorType.NXT_ULTRASONIC, new Point2(0, 0), 0, 0.06,
                List.of(), Optional.empty());
        StepCounter[] made = new StepCounter[1];
        bench.devices.sensor(port).plug(mount, site -> made[0] = new StepCounter(site));
        return made[0];
    }

    @Test
    void eachIsCalledOnceInEveryStep() {
        StepCounter first = plug(0);
        bench.runMillis(10 * STEP_MILLIS);
        StepCounter second = plug(2);
        bench.runMillis(5 * STEP_MILLIS);
        assertThat(first.steps).isEqualTo(15);
        assertThat(second.steps).isEqualTo(5);
    }

    @Test
    void oneThatWasReplacedOrTakenOutIsLeftAlone() {
        StepCounter replaced = plug(0);
        StepCounter stays = plug(1);
        bench.runMillis(10 * STEP_MILLIS);
        StepCounter replacement = plug(0);
        bench.runMillis(10 * STEP_MILLIS);
        bench.devices.sensor(0).plug(null);
        bench.runMillis(10 * STEP_MILLIS);
        assertThat(replaced.steps).isEqualTo(10);
        assertThat(replacement.steps).isEqualTo(10);
        assertThat(stays.steps).isEqualTo(30);
    }
}
