package programs.passing.statics;

/**
 * What the JDK keeps in static fields is a robot's own too: properties, the default handler of exceptions, numbers of
 * threads, thread locals, identity hashes.
 *
 * @expected exited 0
 * @prints Thread-0 1 null
 * @prints caught java.lang.IllegalStateException: on purpose in Thread-1
 * @prints mine 3 true
 * @prints true
 * @prints 1
 */
public class StaticsOfTheJdk {
    private static final ThreadLocal<Integer> LOCAL = ThreadLocal.withInitial(() -> 1);

    static void pause() {
        try {
            Thread.sleep((long) (Math.random() * 10));
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    public static void main(String[] args) throws InterruptedException {
        pause();
        Thread first = new Thread(() -> System.out.println(Thread.currentThread().getName() + " " + LOCAL.get() + " "
                + System.getProperty("robot")));
        first.start();
        first.join();
        System.setProperty("robot", "mine");
        LOCAL.set(3);
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) ->
                System.out.println("caught " + failure + " in " + thread.getName()));
        pause();
        Thread second = new Thread(() -> {
            throw new IllegalStateException("on purpose");
        });
        second.start();
        second.join();
        Object lock = new Object();
        int hash = System.identityHashCode(lock);
        int ofText = System.identityHashCode("constant");
        pause();
        System.out.println(System.getProperty("robot") + " " + LOCAL.get() + " "
                + (hash == System.identityHashCode(lock)));
        System.out.println(ofText == System.identityHashCode("constant"));
        System.out.println(new StaticsOfTheJdk().hashCode() - new int[0].hashCode() < 0 ? 1 : 0);
    }
}
