package lejos.robotics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.lang.reflect.Proxy;
import java.util.Map;
import org.junit.jupiter.api.Test;

class LightScannerTest {
    private int step;

    /** A head that turns by a degree with each question whether it moves, past lamps at 30 and 60 degrees. */
    private final class Lamps implements LightDetector {
        @Override
        public float getLightValue() {
            int angle = Math.min(90, step);
            return Math.max(10, 80 - 8 * Math.min(Math.abs(angle - 30), Math.abs(angle - 60)));
        }

        @Override
        public float getNormalizedLightValue() {
            return getLightValue() / 100;
        }

        @Override
        public float getHigh() {
            return 100;
        }

        @Override
        public float getLow() {
            return 0;
        }
    }

    @Test
    void lampsAreFoundWhereTheyAreBrightest() {
        MotorLog log = new MotorLog(Map.of());
        RegulatedMotor plain = log.as(RegulatedMotor.class);
        RegulatedMotor head = (RegulatedMotor) Proxy.newProxyInstance(getClass().getClassLoader(),
                new Class<?>[] {RegulatedMotor.class}, (self, method, arguments) -> switch (method.getName()) {
                    case "isMoving" -> ++step < 90;
                    case "getTachoCount" -> step;
                    default -> method.invoke(plain, arguments);
                });
        RangeReadings lamps = new LightScanner(head, new Lamps(), 50, 20).scanLight(0, 90, 2, 5);
        assertThat(lamps).extracting(RangeReading::getRange).containsExactly(80f, 80f);
        assertThat(lamps.getAngle(0)).isCloseTo(30, within(1f));
        assertThat(lamps.getAngle(1)).isCloseTo(60, within(1f));
        assertThat(log.calls()).contains("rotateTo[0]", "rotateTo[90, true]", "rotateTo[0, true]");
    }
}
