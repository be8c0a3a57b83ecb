package programs.passing.threads;

/**
 * A subclass of Thread may override start, run and interrupt, and call their originals and inherited static methods.
 *
 * @expected exited 0
 * @prints start
 * @prints run false
 * @prints interrupt
 * @prints slept
 */
public class SubclassOfThread extends Thread {
    SubclassOfThread() {
        super("subclass");
    }

    @Override
    public synchronized void start() {
        System.out.println("start");
        super.start();
    }

    @Override
    public void run() {
        super.run();
        System.out.println("run " + isInterrupted());
        try {
            SubclassOfThread.sleep(10_000);
        } catch (InterruptedException e) {
            System.out.println("slept");
        }
    }

    @Override
    public void interrupt() {
        System.out.println("interrupt");
        super.interrupt();
    }

    public static void main(String[] args) throws InterruptedException {
        SubclassOfThread thread = new SubclassOfThread();
        thread.start();
        sleep(10);
        thread.interrupt();
        thread.join();
    }
}
