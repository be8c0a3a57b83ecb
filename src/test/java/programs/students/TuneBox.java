package programs.students;

import lejos.hardware.Button;
import lejos.hardware.Sound;
import lejos.hardware.lcd.LCD;

/** Plays a tune on one thread while the lights blink on another. */
public class TuneBox extends Thread {
    private static final int C = 262, D = 294, E = 330, F = 349, G = 392, A = 440;
    /** Pitch and number of quarters in turn; 0 is a rest. */
    private static final int[] TUNE = {C, 1, D, 1, E, 1, F, 1, G, 2, G, 2, A, 1, A, 1, A, 1, A, 1, G, 2, 0, 1};
    private static final int QUARTER = 250;

    private final int[] notes;
    private boolean finished;

    public TuneBox(int[] notes) {
        super("musician");
        this.notes = notes;
    }

    @Override
    public void run() {
        for (int i = 0; i < notes.length; i += 2) {
            int ms = notes[i + 1] * QUARTER;
            if (notes[i] == 0) {
                Sound.pause(ms);
            } else {
                Sound.playNote(i % 4 == 0 ? Sound.PIANO : Sound.FLUTE, notes[i], ms);
            }
        }
        synchronized (this) {
            finished = true;
            notifyAll();
        }
    }

    public synchronized boolean isFinished() {
        return finished;
    }

    public static void main(String[] args) throws Exception {
        Sound.setVolume(40);
        TuneBox box = new TuneBox(TUNE);
        long begin = System.currentTimeMillis();
        box.start();
        int blinks = 0;
        while (!box.isFinished()) {
            Button.LEDPattern(1 + blinks % 3);
            LCD.drawString("blink " + blinks, 0, 2);
            blinks++;
            synchronized (box) {
                if (!box.isFinished()) {
                    box.wait(500);
                }
            }
        }
        box.join();
        Button.LEDPattern(0);
        long took = System.currentTimeMillis() - begin;
        Sound.beepSequenceUp();
        System.out.println("volume " + Sound.getVolume());
        System.out.println("quarters " + took / QUARTER);
        System.out.println("blinks " + blinks);
        System.out.println("alive " + box.isAlive());
    }
}
