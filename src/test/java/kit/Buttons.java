package kit;

import lejos.hardware.Button;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;
import lejos.utility.TextMenu;

/** Keys in all ways of asking for them; the test presses them. */
public final class Buttons {
    private static final Stopwatch WATCH = new Stopwatch();

    private Buttons() {}

    public static void main(String[] args) {
        report("first", Button.waitForAnyPress());
        report("timeout", Button.waitForAnyPress(300));
        Delay.msDelay(2000 - WATCH.elapsed());
        System.out.println("lost " + Button.getButtons());
        report("heldBefore", Button.waitForAnyPress());
        report("pressedAnew", Button.waitForAnyPress());
        report("released", Button.waitForAnyEvent());
        report("pressed", Button.waitForAnyEvent());
        Button.DOWN.waitForPressAndRelease();
        report("downAndUp", 0);
        TextMenu menu = new TextMenu(new String[] {"drive", "turn", "stop"}, 1, "choose");
        report("menu", menu.select());
        report("escape", menu.select());
        Delay.msDelay(20_000 - WATCH.elapsed());
    }

    private static void report(String name, int value) {
        System.out.println(name + " " + value + " " + WATCH.elapsed());
    }
}
