package programs.robots;

import brickless.simulation.kit.Left;
import java.util.ArrayList;
import java.util.List;
import lejos.hardware.Button;
import lejos.hardware.Key;
import lejos.hardware.KeyListener;

/** Leaves objects wherever a program can, and ends while a thread still sleeps. */
public class Hoarder {
    private static final List<Object> STATIC = new ArrayList<>();
    private static final ThreadLocal<Object> LOCAL = new ThreadLocal<>();
    private static Runnable captured;

    private Hoarder() {}

    private interface Constants {
        Object IN_INTERFACE = remembered();
    }

    private static final class Listener implements KeyListener {
        @Override
        public void keyPressed(Key key) {
            STATIC.add(key);
        }

        @Override
        public void keyReleased(Key key) {
            STATIC.add(key);
        }
    }

    private static byte[] remembered() {
        byte[] object = new byte[100];
        Left.behind(object);
        return object;
    }

    /** Runs it. */
    public static void main(String[] arguments) {
        STATIC.add(remembered());
        STATIC.add(Constants.IN_INTERFACE);
        LOCAL.set(remembered());
        Object inLambda = remembered();
        captured = () -> STATIC.add(inLambda);
        Object inHook = remembered();
        Runtime.getRuntime().addShutdownHook(new Thread(() -> STATIC.add(inHook)));
        Object inHandler = remembered();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> STATIC.add(inHandler));
        Listener listener = new Listener();
        Left.behind(listener);
        Button.ENTER.addKeyListener(listener);
        Object onStack = remembered();
        Thread sleeper = new Thread(() -> {
            try {
                Thread.sleep(1_000_000);
            } catch (InterruptedException e) {
                STATIC.add(onStack);
            }
        });
        sleeper.setDaemon(true);
        Left.behind(sleeper);
        sleeper.start();
        captured.run();
        System.getProperties().put("hoarder", remembered());
    }
}
