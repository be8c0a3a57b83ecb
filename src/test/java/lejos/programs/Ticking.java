package lejos.programs;

import lejos.utility.Delay;
import lejos.utility.Stopwatch;
import lejos.utility.Timer;

/**
 * Prints the hundreds of milliseconds at which a timer fires: three times, a last time after its stop, and once more
 * after a second start.
 */
public final class Ticking {
    private Ticking() {}

    public static void main(String[] args) {
        Stopwatch watch = new Stopwatch();
        Timer timer = new Timer(200, () -> System.out.println((watch.elapsed() + 20) / 100));
        Delay.msDelay(500);
        System.out.println("start");
        timer.start();
        Delay.msDelay(700);
        timer.stop();
        System.out.println("stop");
        Delay.msDelay(1000);
        System.out.println("again");
        timer.setDelay(300);
        timer.start();
        Delay.msDelay(400);
    }
}
