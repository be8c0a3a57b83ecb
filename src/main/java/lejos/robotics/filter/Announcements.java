package lejos.robotics.filter;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.SocketTimeoutException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;
import lejos.utility.Delay;

/**
 * Hears what samples are published on the network, on a daemon thread that starts with the first question. It listens
 * in short naps, so that the clock of a simulation goes on.
 */
final class Announcements {
    private static final int POLL_MILLIS = 1;
    private static final int NAP_MILLIS = 50;

    /** Guarded by the class. */
    private static final Map<String, PublishedSource> HEARD = new TreeMap<>();
    private static boolean listening;

    private Announcements() {}

    /** What was announced within an age, after listening for a time, both in milliseconds. */
    static Collection<PublishedSource> hear(int port, int size, int millis, int age) {
        listen(port, size);
        Delay.msDelay(millis);
        synchronized (Announcements.class) {
            HEARD.values().removeIf(source -> System.currentTimeMillis() - source.getTimeStamp() > age);
            return new ArrayList<>(HEARD.values());
        }
    }

    private static synchronized void listen(int port, int size) {
        if (!listening) {
            listening = true;
            Thread listener = new Thread(() -> receive(port, size), "announcements");
            listener.setDaemon(true);
            listener.start();
        }
    }

    private static void receive(int port, int size) {
        try (DatagramSocket socket = new DatagramSocket(port)) {
            socket.setSoTimeout(POLL_MILLIS);
            DatagramPacket packet = new DatagramPacket(new byte[size], size);
            while (true) {
                if (arrived(socket, packet)) {
                    note(packet);
                } else {
                    Delay.msDelay(NAP_MILLIS);
                }
            }
        } catch (IOException e) {
            // Another program listens here, or the network is gone: the next question tries again.
            stopped();
        }
    }

    private static boolean arrived(DatagramSocket socket, DatagramPacket packet) throws IOException {
        try {
            socket.receive(packet);
            return true;
        } catch (SocketTimeoutException e) {
            return false;
        }
    }

    private static void note(DatagramPacket packet) throws IOException {
        byte[] message = Arrays.copyOf(packet.getData(), packet.getLength());
        PublishedSource source = new PublishedSource(packet.getAddress().getHostAddress(), message);
        synchronized (Announcements.class) {
            HEARD.put(source.getKey(), source);
        }
    }

    private static synchronized void stopped() {
        listening = false;
    }
}
