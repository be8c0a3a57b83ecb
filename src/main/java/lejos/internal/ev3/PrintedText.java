package lejos.internal.ev3;

/** The layer that printed text goes to. Drawing on it costs no time of its own: printing a line already does. */
final class PrintedText extends EV3TextLCD {
    PrintedText(String layerName) {
        super(layerName);
    }

    @Override
    void spend(int pixels) {
        announceDrawing(); // PrintedBytes reports the work of a whole write
    }

    @Override
    public void refresh() {
        // The automatic copy to the screen is soon enough, and does not block.
    }
}
