package lejos.robotics.filter;

import java.util.Locale;
import lejos.hardware.BrickFinder;
import lejos.hardware.lcd.TextLCD;
import lejos.robotics.SampleProvider;

/** Passes samples on and shows them on the screen, one value a line, as many as there are lines. */
public class Dump extends AbstractFilter {
    private static final String DEFAULT_FORMAT = "%7.3f";

    private final String format;
    private final TextLCD screen = BrickFinder.getDefault().getTextLCD();

    /** Shows values with three decimals. */
    public Dump(SampleProvider source) {
        this(source, DEFAULT_FORMAT);
    }

    /** Shows values in a format of {@link String#format}. */
    public Dump(SampleProvider source, String format) {
        super(source);
        this.format = format;
    }

    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        screen.clear();
        for (int i = 0; i < Math.min(sampleSize, screen.getTextHeight()); i++) {
            screen.drawString(String.format(Locale.ROOT, format, sample[offset + i]), 0, i);
        }
        screen.refresh();
    }
}
