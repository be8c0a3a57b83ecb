package programs.passing.monitors;

/**
 * wait and notify without the monitor throw, and so does a null lock.
 *
 * @expected exited 0
 * @prints wait refused
 * @prints notify refused
 * @prints null refused
 */
public class NotOwner {
    public static void main(String[] args) throws InterruptedException {
        Object lock = new Object();
        try {
            lock.wait();
        } catch (IllegalMonitorStateException e) {
            System.out.println("wait refused");
        }
        try {
            lock.notify();
        } catch (IllegalMonitorStateException e) {
            System.out.println("notify refused");
        }
        Object nothing = args.length == 0 ? null : args;
        try {
            synchronized (nothing) {
                System.out.println("impossible");
            }
        } catch (NullPointerException e) {
            System.out.println("null refused");
        }
    }
}
