package lejos.programs;

import lejos.hardware.Button;
import lejos.utility.Stopwatch;
import lejos.utility.TextMenu;

/** Asks for keys in all ways that block, as programs do before they begin. */
public final class Asking {
    private Asking() {}

    public static void main(String[] args) {
        Stopwatch watch = new Stopwatch();
        System.out.println("key " + Button.waitForAnyPress());
        System.out.println("menu " + new TextMenu(new String[] {"a", "b"}).select());
        Button.ENTER.waitForPressAndRelease();
        System.out.println("done " + watch.elapsed() / 1000 + " s");
    }
}
