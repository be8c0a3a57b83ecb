package programs.passing.threads;

/**
 * Thread groups are harmless: everything is in group main, or in the group that was asked for.
 *
 * @expected exited 0
 * @prints main
 * @prints crew
 * @prints 2 threads
 * @prints interrupted
 */
public class Groups {
    public static void main(String[] args) throws InterruptedException {
        ThreadGroup crew = new ThreadGroup("crew");
        Thread member = new Thread(crew, () -> {
            try {
                Thread.sleep(10_000);
            } catch (InterruptedException e) {
                System.out.println("interrupted");
            }
        });
        System.out.println(Thread.currentThread().getThreadGroup().getName());
        System.out.println(member.getThreadGroup().getName());
        member.start();
        Thread[] all = new Thread[5];
        System.out.println(Thread.enumerate(all) + " threads");
        Thread.sleep(1);
        crew.interrupt();
        member.join();
    }
}
