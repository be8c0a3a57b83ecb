package lejos.hardware.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Proxy;
import lejos.hardware.AttachedBrick;
import lejos.hardware.port.LegacySensorPort;
import lejos.hardware.port.SensorPort;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;

@Timeout(30)
class RCXSensorsTest {
    private static final int[] RAW_BY_PHASE = {1000, 2200, 3200, 4000};

    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    private void turn(RCXRotationSensor sensor, int expectedCount, int phase) {
        brick.sensor(0).analog().raw(RAW_BY_PHASE[phase], 0);
        while (sensor.getRawTachoCount() != expectedCount && !Thread.currentThread().isInterrupted()) {
            Thread.onSpinWait();
        }
        assertEquals(expectedCount, sensor.getRawTachoCount());
    }

    @Test
    void aTurnHasSixteenCountsInBothDirections() {
        brick.sensor(0).analog().raw(RAW_BY_PHASE[0], 0);
        RCXRotationSensor sensor = new RCXRotationSensor(SensorPort.S1);
        int[] forward = {1, 3, 2, 0};
        for (int i = 0; i < forward.length; i++) {
            turn(sensor, i + 1, forward[i]);
        }
        assertEquals(90, sensor.getTachoCount());
        turn(sensor, 3, 2);
        turn(sensor, 2, 3);
        assertEquals(45, sensor.getTachoCount());
        sensor.resetTachoCount();
        assertEquals(0, sensor.getTachoCount());
        turn(sensor, -1, 1);
        assertEquals(-22, sensor.getTachoCount());
        sensor.close();
    }

    @Test
    void theThermometerMeasuresInKelvinOnAPortTheProgramBrings() {
        LegacySensorPort port = (LegacySensorPort) Proxy.newProxyInstance(getClass().getClassLoader(),
                new Class<?>[] {LegacySensorPort.class}, (object, method, arguments) -> 705f * 5 / 1023);
        float[] sample = new float[1];
        new RCXThermometer(port).getTemperatureMode().fetchSample(sample, 0);
        assertEquals(283.15f, sample[0], 0.001f);
    }
}
