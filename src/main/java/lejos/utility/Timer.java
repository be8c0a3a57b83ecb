package lejos.utility;

/**
 * Calls a listener again and again. The period is the delay plus the time the listener takes; the first call comes one
 * delay after the start. After {@link #stop} the delay that runs is finished with one more call, as in leJOS.
 */
public class Timer {
    private final TimerListener listener;
    private int delayMillis;
    private boolean running;
    private Thread thread;

    /**
     * A timer that does not run yet.
     *
     * @param theDelay milliseconds between two calls
     * @param el who is called
     */
    public Timer(int theDelay, TimerListener el) {
        delayMillis = theDelay;
        listener = el;
    }

    /** Milliseconds between two calls. */
    public synchronized int getDelay() {
        return delayMillis;
    }

    /** Sets the milliseconds between two calls, from the next round on. */
    public synchronized void setDelay(int newDelay) {
        delayMillis = newDelay;
    }

    /** Stops after the round that runs. The timer can be started again. */
    public synchronized void stop() {
        running = false;
    }

    /** Starts; has no effect while the timer runs. */
    public synchronized void start() {
        running = true;
        notifyAll();
        if (thread == null) {
            thread = new Thread(this::callForEver, "timer");
            thread.setDaemon(true);
            thread.start();
        }
    }

    private void callForEver() {
        try {
            while (true) {
                awaitStart();
                Delay.msDelay(getDelay());
                listener.timedOut();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized void awaitStart() throws InterruptedException {
        while (!running) {
            wait();
        }
    }
}
