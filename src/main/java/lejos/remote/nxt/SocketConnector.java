package lejos.remote.nxt;

import java.io.IOException;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import lejos.utility.Delay;

/**
 * Makes connections over the network, on port 8888. It waits in short naps, so that the clock of a simulation goes on.
 */
public class SocketConnector extends NXTCommConnector {
    private static final int PORT = 8888;
    private static final int POLL_MILLIS = 1;
    private static final int NAP_MILLIS = 50;

    /** Guarded by this: the socket on which somebody waits, or null. */
    private ServerSocket server;

    /** A connector. */
    public SocketConnector() {}

    @Override
    public NXTConnection connect(String target, int mode) {
        try {
            return new SocketConnection(new Socket(target, PORT));
        } catch (IOException e) {
            return null;
        }
    }

    @Override
    public NXTConnection waitForConnection(int timeout, int mode) {
        try (ServerSocket listening = open()) {
            Socket caller = accept(listening, timeout);
            return caller == null ? null : new SocketConnection(caller);
        } catch (IOException e) {
            return null;
        } finally {
            forget();
        }
    }

    private synchronized ServerSocket open() throws IOException {
        server = new ServerSocket(PORT);
        server.setSoTimeout(POLL_MILLIS);
        return server;
    }

    private synchronized void forget() {
        server = null;
    }

    private static Socket accept(ServerSocket listening, int timeout) throws IOException {
        long end = System.currentTimeMillis() + timeout;
        while (timeout == 0 || System.currentTimeMillis() < end) {
            try {
                return listening.accept();
            } catch (SocketTimeoutException e) {
                Delay.msDelay(NAP_MILLIS);
            }
        }
        return null;
    }

    @Override
    public synchronized boolean cancel() {
        if (server == null) {
            return false;
        }
        try {
            server.close();
            return true;
        } catch (IOException e) {
            return false;
        }
    }
}
