package brickless.device.panel;

import brickless.kernel.Costs;

/** Processor time of panel calls on the brick's 300 MHz ARM9: estimates, in nanoseconds. */
final class PanelCharges {
    /** Reading the key device. Estimate. */
    static final long KEY_READ_NANOS = 20_000;
    /** Writing a pattern to the LED driver. Estimate. */
    static final long LED_NANOS = 100_000;
    /** Handing a sound to the sound driver. Estimate. */
    static final long SOUND_NANOS = 300_000;
    /** Copying the layers to the screen. Estimate. */
    static final long REFRESH_NANOS = 200_000;
    /** Any drawing call. Estimate. */
    static final long DRAW_NANOS = 2_000;
    /** One pixel of a drawing, such that a text line of 17 × 10 × 16 pixels takes 0.5 ms. Estimate. */
    static final long PIXEL_NANOS = Costs.TEXT_LINE_NANOS / (17 * 10 * 16);

    private PanelCharges() {}
}
