package handwritten;

/** A loop that never enters the kernel, as code of the JDK could; a test can stop it from outside. */
public final class HostLoop {
    private volatile boolean stopped;

    /** Loops until stopped. */
    public void loop() {
        while (!stopped) {
            Thread.onSpinWait();
        }
    }

    /** Ends the loop, so that it does not burn the host's processor for ever. */
    public void stop() {
        stopped = true;
    }
}
