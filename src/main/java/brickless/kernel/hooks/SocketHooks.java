package brickless.kernel.hooks;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;

/**
 * Sockets of rewritten code. They are real, so a peer is outside of virtual time; but waiting for one must not stop the
 * robot's other threads: every blocking call asks the host for a millisecond and then lets 20 ms of virtual time pass.
 * Without a peer such a run is repeatable. Per robot.
 */
public final class SocketHooks {
    private static final int HOST_WAIT_MILLIS = 1;
    private static final long PAUSE_MILLIS = 20;
    private static final long NANOS_PER_MILLI = 1_000_000L;

    private SocketHooks() {}

    /** {@code server.accept()}. */
    public static Socket accept(ServerSocket server) throws IOException {
        return blocking(server::accept, server::getSoTimeout, server::setSoTimeout);
    }

    /** {@code socket.receive(packet)}. */
    public static void receive(DatagramSocket socket, DatagramPacket packet) throws IOException {
        blocking(() -> {
            socket.receive(packet);
            return packet;
        }, socket::getSoTimeout, socket::setSoTimeout);
    }

    /** {@code socket.getInputStream()}. */
    public static InputStream getInputStream(Socket socket) throws IOException {
        return new PatientStream(socket.getInputStream(), socket);
    }

    /**
     * Repeats a call that ends after a short host time until it succeeds or the program's own time limit has passed in
     * virtual time.
     */
    private static <T> T blocking(Call<T> call, Timeout timeout, TimeoutSetter setter) throws IOException {
        if (!Hooks.isBound()) {
            return call.run();
        }
        int limitMillis = timeout.get();
        boolean interrupted = false;
        setter.set(HOST_WAIT_MILLIS);
        try {
            for (long waited = 0;; waited += PAUSE_MILLIS) {
                try {
                    return call.run();
                } catch (SocketTimeoutException nobodyThere) {
                    if (limitMillis > 0 && waited >= limitMillis) {
                        throw nobodyThere;
                    }
                }
                interrupted |= pause();
            }
        } finally {
            restore(setter, limitMillis);
            if (interrupted) {
                ThreadHooks.interrupt(Hooks.machine().currentThread());
            }
        }
    }

    /** Whether the pause was interrupted: sockets are not interruptible, so the wait goes on. */
    private static boolean pause() {
        try {
            Hooks.machine().sleep(PAUSE_MILLIS * NANOS_PER_MILLI);
            return false;
        } catch (InterruptedException kept) {
            return true;
        }
    }

    private static void restore(TimeoutSetter setter, int limitMillis) throws IOException {
        try {
            setter.set(limitMillis);
        } catch (SocketException closed) {
            // the program closed the socket while this thread waited: the call itself has thrown
            assert closed != null;
        }
    }

    private interface Call<T> {
        T run() throws IOException;
    }

    private interface Timeout {
        int get() throws IOException;
    }

    private interface TimeoutSetter {
        void set(int millis) throws IOException;
    }

    private static final class PatientStream extends FilterInputStream {
        private final Socket socket;

        PatientStream(InputStream in, Socket socket) {
            super(in);
            this.socket = socket;
        }

        @Override
        public int read() throws IOException {
            return blocking(in::read, socket::getSoTimeout, socket::setSoTimeout);
        }

        @Override
        public int read(byte[] bytes, int offset, int length) throws IOException {
            return blocking(() -> in.read(bytes, offset, length), socket::getSoTimeout, socket::setSoTimeout);
        }
    }
}
