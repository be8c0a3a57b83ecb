package lejos.programs;

import lejos.hardware.Button;
import lejos.hardware.Key;
import lejos.hardware.KeyListener;
import lejos.utility.Delay;

/** Prints what listeners hear until ESCAPE goes up. */
public final class Listening implements KeyListener {
    private static volatile boolean over;

    private final String name;

    private Listening(String name) {
        this.name = name;
    }

    public static void main(String[] args) {
        Button.ENTER.addKeyListener(new Listening("first"));
        Button.ENTER.addKeyListener(new Listening("second"));
        Button.ESCAPE.addKeyListener(new Listening("escape"));
        while (!over) {
            Delay.msDelay(10);
        }
    }

    @Override
    public void keyPressed(Key k) {
        System.out.println(name + " " + k.getName() + " down");
    }

    @Override
    public void keyReleased(Key k) {
        System.out.println(name + " " + k.getName() + " up");
        over = k.getId() == Button.ID_ESCAPE;
    }
}
