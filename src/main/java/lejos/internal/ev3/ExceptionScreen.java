package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import java.util.ArrayList;
import java.util.List;
import lejos.hardware.Keys;
import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.lcd.Font;

/** Shows an exception in the small font on a layer of its own. */
final class ExceptionScreen {
    /** Name of the layer. */
    static final String LAYER = "EXCEPTION";

    private static final int FRAMES = 7;
    private static final int SCROLL_COLUMNS = 5;

    private final List<String> lines;

    ExceptionScreen(Throwable failure) {
        lines = lines(failure);
    }

    private static List<String> lines(Throwable failure) {
        List<String> lines = new ArrayList<>(List.of("Uncaught exception", "", failure.getClass().getName(),
                message(failure), ""));
        Throwable cause = failure.getCause();
        lines.add(cause == null ? "" : "by " + cause.getClass().getName());
        lines.add(cause == null ? "" : message(cause));
        lines.add("");
        StackTraceElement[] frames = failure.getStackTrace();
        for (int i = 0; i < Math.min(FRAMES, frames.length); i++) {
            lines.add(frame(frames[i]));
        }
        return lines;
    }

    private static String message(Throwable failure) {
        return failure.getMessage() == null ? "" : failure.getMessage();
    }

    private static String frame(StackTraceElement frame) {
        String type = frame.getClassName();
        return type.substring(type.lastIndexOf('.') + 1) + "." + frame.getMethodName() + ":" + frame.getLineNumber();
    }

    /**
     * Shows the exception alone until ESCAPE is pressed; LEFT and RIGHT scroll. Without anybody there nothing waits: it
     * stays until the program draws or prints again, so that it is what a program that dies leaves on the screen.
     */
    void show() {
        EV3LCDManager layers = EV3LCDManager.getLocalLCDManager();
        synchronized (ExceptionScreen.class) {
            layers.aboutToDraw();
            EV3TextLCD display = new EV3TextLCD(LAYER, Font.getSmallFont());
            List<EV3LCDManager.LCDLayer> others = new ArrayList<>(List.of(layers.getLayers()));
            others.removeIf(layer -> layer.getName().equals(LAYER));
            others.forEach(layer -> layer.setVisible(false));
            Runnable dismissal = () -> {
                others.forEach(layer -> layer.setVisible(true));
                display.layer.close();
            };
            draw(display, 0);
            if (BrickAccess.brick().keys().attended()) {
                try {
                    scrollUntilEscape(display);
                } finally {
                    dismissal.run();
                    display.refresh();
                }
            } else {
                layers.beforeNextDrawing(dismissal);
            }
        }
    }

    private void scrollUntilEscape(EV3TextLCD display) {
        Keys keys = LocalEV3.get().getKeys();
        keys.discardEvents();
        int firstColumn = 0;
        int event = 0;
        while ((event & Keys.ID_ESCAPE) == 0 && !Thread.currentThread().isInterrupted()) {
            event = keys.waitForAnyEvent();
            if ((event & Keys.ID_RIGHT) != 0) {
                firstColumn += SCROLL_COLUMNS;
            } else if ((event & Keys.ID_LEFT) != 0) {
                firstColumn = Math.max(0, firstColumn - SCROLL_COLUMNS);
            }
            draw(display, firstColumn);
        }
    }

    private void draw(EV3TextLCD display, int firstColumn) {
        display.clear();
        for (int row = 0; row < lines.size(); row++) {
            String line = lines.get(row);
            display.drawString(line.substring(Math.min(firstColumn, line.length())), 0, row);
        }
        display.refresh();
    }
}
