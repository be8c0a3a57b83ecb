package programs.passing.concurrency;

import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.locks.ReentrantReadWriteLock;

/**
 * Readers read together; the writer waits for them.
 *
 * @expected exited 0
 * @prints both read 1
 * @prints wrote 2
 * @prints read 2
 * @prints upgrade false
 */
public class ReadersAndWriter {
    private static final ReentrantReadWriteLock LOCK = new ReentrantReadWriteLock();
    private static final CyclicBarrier TOGETHER =
            new CyclicBarrier(3, () -> System.out.println("both read " + LOCK.getReadLockCount() / 2));
    private static int value = 1;

    private static void read() {
        LOCK.readLock().lock();
        try {
            TOGETHER.await();
        } catch (Exception e) {
            System.out.println(e);
        } finally {
            LOCK.readLock().unlock();
        }
    }

    private static void write() {
        LOCK.writeLock().lock();
        value++;
        System.out.println("wrote " + value);
        LOCK.writeLock().unlock();
    }

    /** The program. */
    public static void main(String[] args) throws Exception {
        Thread[] readers = {new Thread(ReadersAndWriter::read), new Thread(ReadersAndWriter::read)};
        for (Thread reader : readers) {
            reader.start();
        }
        TOGETHER.await();
        Thread writer = new Thread(ReadersAndWriter::write);
        writer.start();
        for (Thread reader : readers) {
            reader.join();
        }
        writer.join();
        LOCK.readLock().lock();
        System.out.println("read " + value);
        System.out.println("upgrade " + LOCK.writeLock().tryLock());
        LOCK.readLock().unlock();
    }
}
