package lejos.robotics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import lejos.hardware.sensor.BaseSensor;
import lejos.hardware.sensor.SensorMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Adapters that find a sensor's modes by their names. */
class SensorAdapterTest {
    /** A sensor of modes that deliver fixed samples. */
    private static final class Fixed extends BaseSensor {
        Fixed(SensorMode... modes) {
            setModes(modes);
        }
    }

    private record Mode(String name, float... values) implements SensorMode {
        @Override
        public String getName() {
            return name;
        }

        @Override
        public int sampleSize() {
            return values.length;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            System.arraycopy(values, 0, sample, offset, values.length);
        }
    }

    @ParameterizedTest
    @CsvSource({"0, false", "1, true", "0.01, true", "-1, false"})
    void anythingAboveZeroIsATouch(float value, boolean pressed) {
        assertThat(new TouchAdapter(new Fixed(new Mode("Touch", value))).isPressed()).isEqualTo(pressed);
    }

    @Test
    void aSensorWithoutTheModeIsRefused() {
        assertThatThrownBy(() -> new TouchAdapter(new Fixed(new Mode("Distance", 1))))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("No such mode Touch");
        assertThatThrownBy(() -> new ColorAdapter(new Fixed(new Mode("RGB", 0, 0, 0))))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("No such mode ColorID");
    }

    @Test
    void componentsOfAColourReach256() {
        ColorAdapter adapter = new ColorAdapter(new Fixed(new Mode("RGB", 0.5f, 1, 0.999f), new Mode("ColorID", 13)));
        assertThat(adapter.getColor().getRed()).isEqualTo(128);
        assertThat(adapter.getColor().getGreen()).isEqualTo(256);
        assertThat(adapter.getColor().getBlue()).isEqualTo(255);
        assertThat(adapter.getColorID()).isEqualTo(Color.BROWN);
    }
}
