package programs.passing.threads;

/**
 * Thread names and ids count up from the program's start, whatever the JVM did before.
 *
 * @expected exited 0
 * @prints main 1 Thread[main,5,main]
 * @prints Thread-0 2 Thread[Thread-0,5,main]
 * @prints named 3 Thread[named,5,main]
 * @prints Thread-1 4 Thread[Thread-1,5,main]
 * @prints renamed
 */
public class NamesAndIds {
    public static void main(String[] args) {
        show(Thread.currentThread());
        show(new Thread());
        show(new Thread("named"));
        Thread last = new Thread(() -> { });
        show(last);
        last.setName("renamed");
        System.out.println(last.getName());
    }

    private static void show(Thread thread) {
        System.out.println(thread.getName() + " " + thread.getId() + " " + thread);
    }
}
