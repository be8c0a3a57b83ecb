package programs.passing.monitors;

import java.util.function.Function;
import java.util.function.Supplier;

/**
 * Method references to waiting, notifying and thread methods work like calls.
 *
 * @expected exited 0
 * @prints notified
 * @prints made Thread-0
 * @prints alive false
 * @prints main
 */
public class MethodReferences {
    private interface Waiting {
        void run() throws InterruptedException;
    }

    public static void main(String[] args) throws InterruptedException {
        MethodReferences lock = new MethodReferences();
        Waiting waiting = lock::wait;
        Runnable notifying = lock::notifyAll;
        Function<Runnable, Thread> factory = Thread::new;
        Thread other = factory.apply(() -> {
            synchronized (lock) {
                notifying.run();
            }
        });
        synchronized (lock) {
            other.start();
            waiting.run();
        }
        System.out.println("notified");
        System.out.println("made " + other.getName());
        other.join();
        Function<Thread, Boolean> alive = Thread::isAlive;
        System.out.println("alive " + alive.apply(other));
        Supplier<Thread> current = Thread::currentThread;
        System.out.println(current.get().getName());
    }
}
