package programs.passing.initialisers;

/**
 * The initialiser of an interface with a default method sleeps, and starts a thread and joins it, while others use the
 * interface and a class that implements it.
 *
 * @expected exited 0
 * @prints made
 * @prints 5 5 5
 * @schedules 20
 */
public class InterfaceStartsThread {
    interface Device {
        int[] PORTS = Opener.open();

        default int port() {
            return PORTS[0];
        }
    }

    static final class Motor implements Device {
    }

    static final class Opener {
        static int[] open() {
            int[] opened = new int[1];
            Thread opening = new Thread(() -> opened[0] = 5);
            opening.start();
            try {
                Thread.sleep(20);
                opening.join();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
            System.out.println("made");
            return opened;
        }
    }

    private static final int[] SEEN = new int[3];

    public static void main(String[] args) throws InterruptedException {
        Thread direct = new Thread(() -> SEEN[0] = Device.PORTS[0]);
        Thread byClass = new Thread(() -> SEEN[1] = new Motor().port());
        Thread byReflection = new Thread(() -> {
            try {
                SEEN[2] = ((int[]) Device.class.getField("PORTS").get(null))[0];
            } catch (ReflectiveOperationException e) {
                throw new IllegalStateException(e);
            }
        });
        direct.start();
        byClass.start();
        byReflection.start();
        direct.join();
        byClass.join();
        byReflection.join();
        System.out.println(SEEN[0] + " " + SEEN[1] + " " + SEEN[2]);
    }
}
