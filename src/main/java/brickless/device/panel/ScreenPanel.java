package brickless.device.panel;

import brickless.hardware.ScreenSocket;
import brickless.kernel.Processor;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;

/** The screen: named layers that the program draws into, copied to the visible picture every 250 ms or on demand. */
public final class ScreenPanel implements ScreenSocket {
    /** Period of the automatic copy in nanoseconds. */
    public static final long REFRESH_PERIOD_NANOS = 250_000_000;

    private static final long LAYER_NAME_NANOS = 2_000_000_000;
    private static final String ALL_LAYERS = "*";

    private final Processor processor;
    private final PanelListener listener;
    private final Map<String, Layer> layers = new LinkedHashMap<>();
    private byte[] shown = new byte[ROW_BYTES * HEIGHT];
    private byte[] spare = new byte[ROW_BYTES * HEIGHT];
    private String layerName;
    private long layerNameUntilNanos;
    private long nextRefreshNanos = REFRESH_PERIOD_NANOS;
    private int soloIndex = -1;

    /** A white screen without layers. */
    public ScreenPanel(Processor processor, PanelListener listener) {
        this.processor = processor;
        this.listener = listener;
    }

    @Override
    public synchronized byte[] layer(String name) {
        return layers.computeIfAbsent(name, key -> new Layer()).memory;
    }

    @Override
    public synchronized void setVisible(String name, boolean visible) {
        layers.computeIfAbsent(name, key -> new Layer()).visible = visible;
    }

    @Override
    public synchronized void setAutoRefresh(String name, boolean automatic) {
        layers.computeIfAbsent(name, key -> new Layer()).autoRefresh = automatic;
    }

    @Override
    public void refresh() {
        processor.charge(PanelCharges.REFRESH_NANOS);
        compose(processor.nowNanos());
    }

    @Override
    public void drawn(int pixels) {
        processor.charge(PanelCharges.DRAW_NANOS + PanelCharges.PIXEL_NANOS * pixels);
    }

    @Override
    public synchronized byte[] displayed() {
        return shown.clone();
    }

    /** Until this time {@link #step} does nothing. */
    public long nextRefreshNanos() {
        return nextRefreshNanos;
    }

    /** Copies the layers to the screen when the period is over; called at each physics step with the present time. */
    public void step(long nowNanos) {
        if (nowNanos < nextRefreshNanos) {
            return;
        }
        nextRefreshNanos = (nowNanos / REFRESH_PERIOD_NANOS + 1) * REFRESH_PERIOD_NANOS;
        if (layerName != null || refreshesItself()) {
            compose(nowNanos);
        }
    }

    /** Copies everything drawn so far to the screen, for the picture at the end of a run. */
    public void settle() {
        compose(processor.nowNanos());
    }

    /**
     * Shows the next layer alone, in the order of their creation, then all together; its name is shown in large letters
     * for 2 s.
     */
    public synchronized void showNextLayer(long nowNanos) {
        soloIndex = soloIndex + 1 < layers.size() ? soloIndex + 1 : -1;
        layerName = ALL_LAYERS;
        int index = 0;
        for (Map.Entry<String, Layer> entry : layers.entrySet()) {
            boolean solo = index++ == soloIndex;
            entry.getValue().visible = solo || soloIndex < 0;
            if (solo) {
                layerName = entry.getKey();
            }
        }
        layerNameUntilNanos = nowNanos + LAYER_NAME_NANOS;
        compose(nowNanos);
    }

    /** The visible picture as text, as far as it was written with the brick's fonts. */
    public String asText() {
        return ScreenText.read(displayed());
    }

    /** The visible picture as text in the small font. */
    public String asSmallText() {
        return ScreenText.readSmall(displayed());
    }

    /** The visible picture as a PNG file. */
    public byte[] asPng() {
        return ScreenImage.png(displayed());
    }

    private synchronized boolean refreshesItself() {
        for (Layer layer : layers.values()) {
            if (layer.visible && layer.autoRefresh) {
                return true;
            }
        }
        return false;
    }

    private synchronized void compose(long nowNanos) {
        Arrays.fill(spare, (byte) 0);
        for (Layer layer : layers.values()) {
            if (layer.visible) {
                layer.addTo(spare);
            }
        }
        if (layerName != null && nowNanos < layerNameUntilNanos) {
            LayerCaption.draw(layerName, spare);
        } else {
            layerName = null;
        }
        if (!Arrays.equals(shown, spare)) {
            byte[] old = shown;
            shown = spare;
            spare = old;
            listener.screenChanged(nowNanos);
        }
    }

    /** One layer; its memory is written by the program without any lock, as on the brick. */
    private static final class Layer {
        /** Most layers are never drawn into; comparing is much cheaper than adding. */
        private static final byte[] BLANK = new byte[ROW_BYTES * HEIGHT];

        private final byte[] memory = new byte[ROW_BYTES * HEIGHT];
        private boolean visible = true;
        private boolean autoRefresh = true;

        void addTo(byte[] picture) {
            if (Arrays.equals(memory, BLANK)) {
                return;
            }
            for (int i = 0; i < picture.length; i++) {
                picture[i] |= memory[i];
            }
        }
    }
}
