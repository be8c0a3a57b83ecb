package brickless.kernel.hooks;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Monitors for rewritten code that runs without a kernel, on JDK locks: bytecode's unpaired enter and exit have no Java
 * equivalent.
 */
final class HostMonitors {
    private final Map<Identity, Monitor> monitors = new HashMap<>();

    void enter(Object lock) {
        if (lock == null) {
            throw new NullPointerException();
        }
        Monitor monitor;
        synchronized (monitors) {
            monitor = monitors.computeIfAbsent(new Identity(lock), key -> new Monitor());
            monitor.users++;
        }
        monitor.lock.lock();
    }

    void exit(Object lock) {
        Monitor monitor = owned(lock);
        monitor.lock.unlock();
        synchronized (monitors) {
            if (--monitor.users == 0) {
                monitors.remove(new Identity(lock));
            }
        }
    }

    void await(Object lock, long nanos) throws InterruptedException {
        Condition condition = owned(lock).condition;
        if (nanos == 0) {
            condition.await();
        } else {
            condition.await(nanos, TimeUnit.NANOSECONDS);
        }
    }

    void signal(Object lock, boolean all) {
        Condition condition = owned(lock).condition;
        if (all) {
            condition.signalAll();
        } else {
            condition.signal();
        }
    }

    boolean held(Object lock) {
        synchronized (monitors) {
            Monitor monitor = monitors.get(new Identity(lock));
            return monitor != null && monitor.lock.isHeldByCurrentThread();
        }
    }

    private Monitor owned(Object lock) {
        synchronized (monitors) {
            Monitor monitor = monitors.get(new Identity(lock));
            if (monitor == null || !monitor.lock.isHeldByCurrentThread()) {
                throw new IllegalMonitorStateException("current thread is not owner");
            }
            return monitor;
        }
    }

    /** {@code users} counts enters without exit; guarded by the map's monitor. */
    private static final class Monitor {
        private final ReentrantLock lock = new ReentrantLock();
        private final Condition condition = lock.newCondition();
        private int users;
    }

    private static final class Identity {
        private final Object object;

        Identity(Object object) {
            this.object = object;
        }

        @Override
        public int hashCode() {
            return System.identityHashCode(object);
        }

        @Override
        public boolean equals(Object other) {
            return other instanceof Identity && ((Identity) other).object == object;
        }
    }
}
