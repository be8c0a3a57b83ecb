package programs.students;

import java.util.HashMap;
import java.util.LinkedList;
import java.util.Map;
import java.util.Queue;
import lejos.hardware.Button;
import lejos.hardware.Key;
import lejos.hardware.KeyListener;
import lejos.hardware.motor.Motor;
import lejos.utility.Timer;
import lejos.utility.TimerListener;

/** Keys queue dance steps; a timer takes one each second. */
public class KeyDancer implements KeyListener, TimerListener {
    private final Queue<String> steps = new LinkedList<>();
    private final Map<Integer, String> names = new HashMap<>();
    private int ticks;
    private volatile boolean over;

    public KeyDancer() {
        names.put(Button.ID_LEFT, "left");
        names.put(Button.ID_RIGHT, "right");
        names.put(Button.ID_UP, "jump");
        for (Key key : new Key[] {Button.LEFT, Button.RIGHT, Button.UP, Button.ESCAPE}) {
            key.addKeyListener(this);
        }
    }

    @Override
    public void keyPressed(Key k) {
        if (k.getId() == Button.ID_ESCAPE) {
            over = true;
            return;
        }
        synchronized (steps) {
            steps.add(names.get(k.getId()));
        }
    }

    @Override
    public void keyReleased(Key k) {
        Button.LEDPattern(0);
    }

    @Override
    public void timedOut() {
        ticks++;
        String step;
        synchronized (steps) {
            step = steps.poll();
        }
        if (step == null) {
            return;
        }
        Button.LEDPattern(4);
        System.out.println(step);
        int angle = step.equals("left") ? -180 : 180;
        if (step.equals("jump")) {
            Motor.B.rotate(90, true);
            Motor.C.rotate(90);
        } else {
            Motor.B.rotate(angle, true);
            Motor.C.rotate(-angle);
        }
    }

    public static void main(String[] args) throws InterruptedException {
        KeyDancer dancer = new KeyDancer();
        Timer timer = new Timer(1000, dancer);
        timer.start();
        while (!dancer.over) {
            Thread.sleep(50);
        }
        timer.stop();
        System.out.println("ticks " + (dancer.ticks >= 5));
        System.exit(dancer.steps.isEmpty() ? 0 : 1);
    }
}
