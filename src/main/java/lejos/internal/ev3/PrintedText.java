package lejos.internal.ev3;

/** The layer that printed text goes to. Drawing on it costs no time of its own: printing a line already does. */
final class PrintedText extends EV3TextLCD {
    PrintedText(String layerName) {
        super(layerName);
    }

    @Override
    void spend(int pixels) {
        // Nothing may block here: the print stream that calls is locked.
    }

    @Override
    public void refresh() {
        // The automatic copy to the screen is soon enough, and does not block.
    }
}
