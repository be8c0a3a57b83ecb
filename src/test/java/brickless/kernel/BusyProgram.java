package brickless.kernel;

/** A program in which threads work, sleep, poll, contend for a lock and wait for each other. */
final class BusyProgram {
    private BusyProgram() {
    }

    static void run(Robot robot, int threads, int rounds) throws Exception {
        Object lock = new Object();
        int[] shared = new int[1];
        for (int t = 0; t < threads; t++) {
            int number = t;
            robot.startDaemon("t" + t, () -> {
                for (int i = 0; i < rounds; i++) {
                    oneRound(robot, lock, shared, number, i);
                }
            });
        }
        for (int i = 0; i < rounds; i++) {
            robot.locked(lock, () -> robot.kernel.monitorWait(lock, 7 * Robot.MILLI));
            robot.work(100_000 + shared[0] * 1_000L);
        }
    }

    private static void oneRound(Robot robot, Object lock, int[] shared, int number, int round) throws Exception {
        switch ((number + round) % 4) {
            case 0 -> robot.work(1_700_000 + 10_000L * number);
            case 1 -> robot.sleepMillis(1 + (robot.kernel.nextRandomLong() & 3));
            case 2 -> robot.kernel.yieldProcessor();
            default -> robot.kernel.charge(Costs.SENSOR_READ_NANOS);
        }
        robot.locked(lock, () -> {
            shared[0] = (shared[0] * 31 + number) & 0xff;
            robot.work(20_000);
            robot.kernel.monitorNotify(lock, round % 5 == 0);
        });
    }
}
