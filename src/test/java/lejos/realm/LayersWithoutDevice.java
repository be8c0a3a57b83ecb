package lejos.realm;

/**
 * Stands in for {@code lejos.internal.ev3.EV3LCDManager} of the published jar, which opens the brick's frame buffer:
 * renamed to it by {@link OriginalScreen}.
 */
public final class LayersWithoutDevice {
    private static final LayersWithoutDevice LOCAL = new LayersWithoutDevice();

    public static LayersWithoutDevice getLocalLCDManager() {
        return LOCAL;
    }
}
