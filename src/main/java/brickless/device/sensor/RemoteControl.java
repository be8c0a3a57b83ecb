package brickless.device.sensor;

/** The infrared remote that somebody points at a robot. */
public final class RemoteControl {
    private static final int CHANNELS = 4;
    private final int[] codes = new int[CHANNELS];

    /**
     * Presses or releases buttons.
     *
     * @param channel 1 to 4
     * @param code 0 = none to 11, as leJOS numbers them
     */
    public void press(int channel, int code) {
        if (channel < 1 || channel > CHANNELS || code < 0 || code > 11) {
            throw new IllegalArgumentException("remote channel is 1 to 4 and code 0 to 11, not " + channel + ", "
                    + code);
        }
        codes[channel - 1] = code;
    }

    int code(int channelIndex) {
        return codes[channelIndex];
    }
}
