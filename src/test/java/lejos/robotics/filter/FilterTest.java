package lejos.robotics.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.FileNotFoundException;
import lejos.Agreement;
import lejos.robotics.SampleProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class FilterTest {
    @Test
    void filtersAgreeWithThePublishedOnes() {
        Agreement.check(FilterDriver.class, 1000, 2e-4, FilterDriver::play);
    }

    @Test
    void meanOfFewerSamplesInTheBeginning() {
        assertThat(outputs(new MeanFilter(values(1, 2, 3, 4), 3), 4)).containsExactly(1, 1.5f, 2, 3);
    }

    @Test
    void meanRespectsTheOffset() {
        float[] sample = {77, 88, 99};
        MeanFilter mean = new MeanFilter(values(2, 4), 3);
        mean.fetchSample(sample, 1);
        mean.fetchSample(sample, 1);
        assertThat(sample).containsExactly(77, 3, 99);
    }

    @Test
    void medianOfTheLastThree() {
        assertThat(outputs(new MedianFilter(values(1, 9, 2, 8, 3, 7), 3), 6)).containsExactly(1, 1, 2, 8, 3, 7);
    }

    @Test
    void maximumIsWrittenEvenIfUnchanged() {
        float[] sample = new float[1];
        MaximumFilter maximum = new MaximumFilter(values(5, 1, 1), 2);
        maximum.fetchSample(sample, 0);
        float[] other = {100};
        maximum.fetchSample(other, 0);
        assertThat(other).containsExactly(5);
        maximum.fetchSample(other, 0);
        assertThat(other).containsExactly(1);
    }

    @Test
    void minimumForgetsOldSamples() {
        assertThat(outputs(new MinimumFilter(values(1, 5, 4, 6, 7), 2), 5)).containsExactly(1, 1, 4, 4, 6);
    }

    @Test
    void emptyBufferIsRefused() {
        assertThatThrownBy(() -> new MinimumFilter(values(1), 0)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void modulusFarBelowZeroIsNegativeAsInLejos() {
        assertThat(outputs(new ModulusFilter(values(-400, 370), new float[] {20}, 360), 2)).containsExactly(-60, 350);
    }

    @Test
    void integralBeginsWithTheValueSet() {
        IntegrationFilter integral = new IntegrationFilter(values(3, 4));
        integral.resetTo(7);
        assertThat(outputs(integral, 1)).containsExactly(7);
    }

    @Test
    void lowPassFirstSamplePassesAndASlowOneHardlyMoves() {
        float[] outputs = outputs(new LowPassFilter(values(10, 20), 1e9f), 2);
        assertThat(outputs[0]).isEqualTo(10);
        assertThat(outputs[1]).isBetween(10f, 10.001f);
    }

    @Test
    void calibrationOfNegativeSignals() {
        LinearCalibrationFilter filter = new LinearCalibrationFilter(values(-5, -3, -4, -4));
        filter.startCalibration();
        outputs(filter, 3);
        filter.stopCalibration();
        assertThat(filter.getOffsetCorrection()).containsExactly(-4);
        assertThat(outputs(filter, 1)).containsExactly(0);
    }

    @Test
    void unknownCalibrationTypeIsRefused() {
        assertThatThrownBy(() -> new LinearCalibrationFilter(values(1)).setCalibrationType(2))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void savedCalibrationIsOpened() {
        LinearCalibrationFilter filter = new LinearCalibrationFilter(values(10, 20, 15));
        filter.setCalibrationType(LinearCalibrationFilter.OFFSET_AND_SCALE_CALIBRATION);
        filter.setScaleCalibration(1);
        filter.startCalibration();
        outputs(filter, 2);
        filter.stopCalibration();
        filter.save("saved");
        LinearCalibrationFilter opened = new LinearCalibrationFilter(values(20), "saved");
        assertThat(opened.getOffsetCorrection()).containsExactly(15);
        assertThat(opened.getScaleCorrection()).containsExactly(5);
        assertThat(outputs(opened, 1)).containsExactly(1);
    }

    @Test
    void calibrationThatDoesNotFitIsNotUsed() {
        LinearCalibrationFilter filter = new LinearCalibrationFilter(values(10));
        filter.save("small");
        LinearCalibrationFilter other = new LinearCalibrationFilter(new RandomSource(1, 2, 0), "small");
        assertThat(other.getScaleCorrection()).containsExactly(1, 1);
        assertThatThrownBy(() -> other.load("small"))
                .isInstanceOf(AbstractCalibrationFilter.CalibrationFileException.class);
        assertThatThrownBy(() -> other.load("never saved")).isInstanceOf(FileNotFoundException.class);
    }

    @Test
    void terminalReadsTheElementChosen() {
        FilterTerminal terminal = new FilterTerminal(new ConcatenationFilter(values(0, 0, 0), values(1, 0, 7)));
        assertThat(terminal.isFalse()).isTrue();
        terminal.setIndex(1);
        assertThat(terminal.isTrue()).isFalse();
        assertThat(terminal.fetch()).isEqualTo(7);
        assertThatThrownBy(() -> terminal.setIndex(2)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    @Timeout(10)
    void sampleThreadDeliversSamplesOfItsOwnAccord() {
        SampleThread thread = new SampleThread(new RandomSource(1, 1, 5), 1000);
        while (!thread.isNewSampleAvailable()) {
            Thread.onSpinWait();
        }
        assertThat(outputs(thread, 1)[0]).isGreaterThanOrEqualTo(5);
        thread.stop();
        assertThat(thread.getSampleRate()).isEqualTo(1000);
    }

    private static float[] outputs(SampleProvider filter, int count) {
        float[] outputs = new float[count];
        for (int i = 0; i < count; i++) {
            filter.fetchSample(outputs, i);
        }
        return outputs;
    }

    private static SampleProvider values(float... values) {
        return new SampleProvider() {
            private int next;

            @Override
            public int sampleSize() {
                return 1;
            }

            @Override
            public void fetchSample(float[] sample, int offset) {
                sample[offset] = values[next++];
            }
        };
    }
}
