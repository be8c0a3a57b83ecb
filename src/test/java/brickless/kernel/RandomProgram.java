package brickless.kernel;

import java.util.ArrayList;
import java.util.List;

/** A program drawn from the kernel's seed that mixes everything threads can do to each other; it always ends. */
final class RandomProgram {
    private static final int ROUNDS = 25;

    private final Robot robot;
    private final Object[] locks = {new Object(), "lock", RandomProgram.class};
    private final List<Thread> threads = new ArrayList<>();
    private final Processor.Signal signal;

    private RandomProgram(Robot robot) {
        this.robot = robot;
        this.signal = robot.kernel.newSignal();
    }

    static void run(Robot robot) {
        RandomProgram program = new RandomProgram(robot);
        int count = 2 + program.random(5);
        for (int i = 0; i < count; i++) {
            program.startOne();
        }
        program.rounds();
    }

    private void startOne() {
        threads.add(robot.start("t" + threads.size(), this::rounds));
    }

    private void rounds() {
        for (int i = 0; i < ROUNDS; i++) {
            try {
                act();
            } catch (InterruptedException e) {
                robot.note("interrupted " + robot.kernel.currentThread().getName());
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        }
    }

    private void act() throws Exception {
        long nanos = 1 + random(4_000_000);
        Object lock = locks[random(locks.length)];
        Thread other = threads.get(random(threads.size()));
        switch (random(13)) {
            case 0 -> robot.kernel.sleep(nanos);
            case 1 -> robot.work(nanos / 4);
            case 2 -> robot.kernel.yieldProcessor();
            case 3 -> robot.kernel.charge(nanos);
            case 4 -> robot.locked(lock, () -> robot.kernel.monitorWait(lock, nanos));
            case 5 -> robot.locked(lock, () -> robot.kernel.monitorNotify(lock, nanos % 2 == 0));
            case 6 -> robot.kernel.join(other, nanos);
            case 7 -> robot.kernel.interrupt(other);
            case 8 -> robot.kernel.park(nanos);
            case 9 -> robot.kernel.unpark(other);
            case 10 -> robot.locked(locks[0], () -> robot.locked(lock, () -> robot.kernel.charge(nanos / 8)));
            case 11 -> robot.kernel.at(robot.kernel.nowNanos() + nanos, signal::raise);
            default -> awaitOrStart(nanos);
        }
    }

    private void awaitOrStart(long nanos) throws InterruptedException {
        if (threads.size() < 9 && nanos % 4 == 0) {
            startOne();
        } else {
            robot.note("raised " + signal.awaitInterruptibly(nanos));
        }
    }

    private int random(int bound) {
        return (int) Math.floorMod(robot.kernel.nextRandomLong() >>> 16, (long) bound);
    }
}
