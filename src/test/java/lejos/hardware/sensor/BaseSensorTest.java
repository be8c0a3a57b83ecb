package lejos.hardware.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import lejos.hardware.Device;
import lejos.hardware.DeviceException;
import org.junit.jupiter.api.Test;

/** The mode list every sensor has, and the closing of devices. */
class BaseSensorTest {
    private static final class Constant implements SensorMode {
        private final String name;
        private final int size;

        Constant(String name, int size) {
            this.name = name;
            this.size = size;
        }

        @Override
        public int sampleSize() {
            return size;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            for (int i = 0; i < size; i++) {
                sample[offset + i] = size;
            }
        }

        @Override
        public String getName() {
            return name;
        }
    }

    private static final class TwoModes extends BaseSensor {
        TwoModes() {
            setModes(new SensorMode[] {new Constant("One", 1), new Constant("Three", 3)});
        }
    }

    private final BaseSensor sensor = new TwoModes();

    @Test
    void theFirstModeIsTheCurrentOneAtFirst() {
        assertEquals(0, sensor.getCurrentMode());
        assertEquals(2, sensor.getModeCount());
        assertEquals("One", sensor.getName());
        assertEquals(1, sensor.sampleSize());
        float[] sample = {0, 0};
        sensor.fetchSample(sample, 1);
        assertEquals(1, sample[1]);
    }

    @Test
    void theSensorStandsForItsCurrentMode() {
        sensor.setCurrentMode(1);
        assertEquals("Three", sensor.getName());
        assertEquals(3, sensor.sampleSize());
        sensor.setCurrentMode("One");
        assertEquals(0, sensor.getCurrentMode());
    }

    @Test
    void modesAreAlwaysTheSameObjects() {
        assertSame(sensor.getMode(1), sensor.getMode(1));
        assertSame(sensor.getMode(1), sensor.getMode("Three"));
    }

    @Test
    void namesAreListedOnceInOrder() {
        assertEquals(new ArrayList<>(List.of("One", "Three")), sensor.getAvailableModes());
        assertSame(sensor.getAvailableModes(), sensor.getAvailableModes());
    }

    @Test
    void aNegativeIndexThrowsAndOneTooLargeIsNull() {
        assertEquals("Invalid mode -1",
                assertThrows(IllegalArgumentException.class, () -> sensor.getMode(-1)).getMessage());
        assertNull(sensor.getMode(2));
        assertNull(sensor.getMode(1000));
    }

    @Test
    void namesMustMatchExactly() {
        for (String name : new String[] {"one", "One ", "", "Two"}) {
            var refusal = assertThrows(IllegalArgumentException.class, () -> sensor.getMode(name));
            assertEquals("No such mode " + name, refusal.getMessage());
        }
    }

    @Test
    void aRefusalNamesTheModesThereAre() {
        var refusal = assertThrows(IllegalArgumentException.class, () -> sensor.getMode("Two"));
        assertEquals("TwoModes has the modes One, Three", refusal.getCause().getMessage());
    }

    @Test
    void unknownModesCannotBecomeCurrent() {
        assertEquals("Invalid mode 2",
                assertThrows(IllegalArgumentException.class, () -> sensor.setCurrentMode(2)).getMessage());
        assertEquals("Invalid mode -1",
                assertThrows(IllegalArgumentException.class, () -> sensor.setCurrentMode(-1)).getMessage());
        assertEquals("Invalid mode Two",
                assertThrows(IllegalArgumentException.class, () -> sensor.setCurrentMode("Two")).getMessage());
        assertEquals(0, sensor.getCurrentMode());
    }

    @Test
    void aTooSmallArrayThrows() {
        sensor.setCurrentMode(1);
        assertThrows(ArrayIndexOutOfBoundsException.class, () -> sensor.fetchSample(new float[3], 1));
    }

    @Test
    void closingReleasesWhatWasRegisteredEveryTime() {
        List<String> closed = new ArrayList<>();
        Device device = new Device() {
            {
                releaseOnClose(() -> closed.add("first"));
                releaseOnClose(() -> closed.add("second"));
            }
        };
        device.close();
        device.close();
        assertEquals(List.of("first", "second", "first", "second"), closed);
    }

    @Test
    void aFailureWhileClosingIsWrapped() {
        IOException trouble = new IOException("stuck");
        Closeable stuck = () -> {
            throw trouble;
        };
        Device device = new Device() {
            {
                releaseOnClose(stuck);
            }
        };
        var failure = assertThrows(DeviceException.class, device::close);
        assertEquals("Error during close", failure.getMessage());
        assertSame(trouble, failure.getCause());
    }
}
