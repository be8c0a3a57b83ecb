package programs.passing.concurrency;

import java.util.concurrent.Exchanger;
import java.util.concurrent.Phaser;

/**
 * A phaser counts rounds, an exchanger swaps.
 *
 * @expected exited 0
 * @prints phase 0 with 2
 * @prints phase 1 with 2
 * @prints ended true
 * @prints main got from thread
 * @prints thread got from main
 */
public class PhaserAndExchanger {
    /** The program. */
    public static void main(String[] args) throws Exception {
        Phaser phaser = new Phaser(2) {
            @Override
            protected boolean onAdvance(int phase, int parties) {
                System.out.println("phase " + phase + " with " + parties);
                return phase == 1;
            }
        };
        Thread party = new Thread(() -> {
            phaser.arriveAndAwaitAdvance();
            phaser.arriveAndAwaitAdvance();
        });
        party.start();
        phaser.arriveAndAwaitAdvance();
        phaser.arriveAndAwaitAdvance();
        party.join();
        System.out.println("ended " + phaser.isTerminated());
        Exchanger<String> exchanger = new Exchanger<>();
        String[] received = new String[1];
        Thread partner = new Thread(() -> {
            try {
                received[0] = exchanger.exchange("from thread");
            } catch (InterruptedException e) {
                System.out.println("interrupted");
            }
        });
        partner.start();
        System.out.println("main got " + exchanger.exchange("from main"));
        partner.join();
        System.out.println("thread got " + received[0]);
    }
}
