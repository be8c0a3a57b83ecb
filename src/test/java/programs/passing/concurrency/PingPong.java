package programs.passing.concurrency;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Two threads take turns by a lock and two conditions.
 *
 * @expected exited 0
 * @prints ping 1
 * @prints pong 1
 * @prints ping 2
 * @prints pong 2
 * @prints ping 3
 * @prints pong 3
 * @prints locked false
 */
public class PingPong {
    private static final ReentrantLock LOCK = new ReentrantLock();
    private static final Condition PINGED = LOCK.newCondition();
    private static final Condition PONGED = LOCK.newCondition();
    private static boolean pingsTurn = true;

    private static void play(String name, boolean turn, Condition myTurn, Condition othersTurn) {
        for (int i = 1; i <= 3; i++) {
            LOCK.lock();
            try {
                while (pingsTurn != turn) {
                    myTurn.awaitUninterruptibly();
                }
                System.out.println(name + " " + i);
                pingsTurn = !turn;
                othersTurn.signal();
            } finally {
                LOCK.unlock();
            }
        }
    }

    /** The program. */
    public static void main(String[] args) throws Exception {
        Thread ping = new Thread(() -> play("ping", true, PONGED, PINGED));
        Thread pong = new Thread(() -> play("pong", false, PINGED, PONGED));
        pong.start();
        ping.start();
        ping.join();
        pong.join();
        System.out.println("locked " + LOCK.isLocked());
    }
}
