package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import brickless.hardware.ScreenSocket;
import java.io.Closeable;
import java.util.ArrayList;
import java.util.List;

/** Keeps the layers of the screen; the screen itself is the socket's business. */
public class EV3LCDManager {
    /** Period of the automatic copy to the screen in milliseconds. */
    public static final int DEFAULT_REFRESH_PERIOD = 250;

    private static final EV3LCDManager LOCAL = new EV3LCDManager();

    private final List<LCDLayer> layers = new ArrayList<>();
    /** What the next drawing has to do first, null for nothing. Written under this lock. */
    private volatile Runnable beforeNextDrawing;

    /** The only one, made by {@link #getLocalLCDManager()}. */
    private EV3LCDManager() {}

    /** The one of the local brick. */
    public static EV3LCDManager getLocalLCDManager() {
        return LOCAL;
    }

    /** The layer of that name, opened once more; created if need be. */
    public synchronized LCDLayer getLayer(String name) {
        LCDLayer layer = findLayer(name);
        if (layer == null) {
            layer = newLayer(name);
        }
        layer.open();
        return layer;
    }

    /** A new layer above all others, closed. */
    public synchronized LCDLayer newLayer(String name) {
        LCDLayer layer = new LCDLayer(name);
        layers.add(layer);
        return layer;
    }

    /** All layers in the order of their creation. */
    public synchronized LCDLayer[] getLayers() {
        return layers.toArray(new LCDLayer[0]);
    }

    /** A copy of what the screen shows. */
    public byte[] getHWDisplay() {
        return BrickAccess.brick().screen().displayed();
    }

    /** Has something done before the program draws or prints the next time. */
    synchronized void beforeNextDrawing(Runnable action) {
        beforeNextDrawing = action;
    }

    /** The program is about to draw on a layer. */
    void aboutToDraw() {
        if (beforeNextDrawing != null) {
            synchronized (this) {
                Runnable action = beforeNextDrawing;
                beforeNextDrawing = null;
                if (action != null) {
                    action.run();
                }
            }
        }
    }

    /** The layer of that name, null if there is none. */
    protected LCDLayer findLayer(String name) {
        for (LCDLayer layer : layers) {
            if (layer.getName().equals(name)) {
                return layer;
            }
        }
        return null;
    }

    /** One layer of the screen. It is shown while it is open and visible. */
    public static class LCDLayer implements Closeable {
        private final ScreenSocket screen = BrickAccess.brick().screen();
        private final String name;
        private final byte[] display;
        private boolean visible = true;
        private int openCount;

        /** A layer that is not shown until it is opened. */
        public LCDLayer(String name) {
            this.name = name;
            this.display = screen.layer(name);
            show();
        }

        /** Shows the layer; each call needs a {@link #close}. */
        public synchronized void open() {
            openCount++;
            show();
        }

        @Override
        public synchronized void close() {
            if (openCount > 0) {
                openCount--;
                show();
            }
        }

        /** Whether somebody holds the layer open. */
        public synchronized boolean isOpen() {
            return openCount > 0;
        }

        /** Shows or hides the layer. */
        public synchronized void setVisible(boolean visible) {
            this.visible = visible;
            show();
        }

        /** Whether the layer is copied to the screen every 250 ms. */
        public void setAutoRefresh(boolean refresh) {
            screen.setAutoRefresh(name, refresh);
        }

        /** Name of the layer. */
        public String getName() {
            return name;
        }

        /** The live memory of the layer. */
        public byte[] getDisplay() {
            return display;
        }

        /** Copies all visible layers to the screen now. */
        public void refresh() {
            screen.refresh();
        }

        private synchronized void show() {
            screen.setVisible(name, visible && openCount > 0);
        }
    }
}
