package lejos.robotics.filter;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.ArrayList;
import lejos.hardware.BrickFinder;
import lejos.robotics.SampleProvider;
import lejos.utility.Delay;

/**
 * Passes samples on, and sends each to everybody on the network who has subscribed.
 *
 * <p>Two daemon threads say once a second by UDP broadcast that the samples are there, and take subscriptions by TCP.
 * The list of subscribers is guarded by its own lock.
 */
public class PublishFilter extends AbstractFilter {
    /** UDP port on which samples are announced. */
    protected static final int PUBLISH_PORT = 3017;
    /** Milliseconds between announcements. */
    protected static final int UDP_PERIOD = 1000;

    private static final int ACCEPT_MILLIS = 1;
    private static final int NAP_MILLIS = 50;
    private static final byte[] BROADCAST = {(byte) 255, (byte) 255, (byte) 255, (byte) 255};

    /** Name of the samples. */
    protected String name;
    /** Name of the brick. */
    protected String host;
    /** Sends announcements. */
    protected DatagramSocket datagramSocket;
    /** Announces. */
    protected Publisher publisher;
    /** Takes subscriptions. */
    protected Listener listener;
    /** The latest sample. */
    protected float[] latest;
    /** How often samples are fetched, in hertz, as the program says. */
    protected float frequency;
    /** What is announced. */
    protected byte[] publishMessage;
    /** What is announced, to where. */
    protected DatagramPacket publishPacket;
    /** Where to subscribe. */
    protected ServerSocket ss;
    /** Who has subscribed. */
    protected ArrayList<Socket> subscribers = new ArrayList<>();

    /**
     * Publishes samples.
     *
     * @param source where samples come from
     * @param name name of the samples
     * @param frequency how often samples are fetched, in hertz; only told
     * @throws IOException if the network is not there
     */
    public PublishFilter(SampleProvider source, String name, float frequency) throws IOException {
        super(source);
        this.name = name;
        this.frequency = frequency;
        this.host = BrickFinder.getDefault().getName();
        this.latest = new float[sampleSize];
        ss = new ServerSocket(0);
        ss.setSoTimeout(ACCEPT_MILLIS);
        datagramSocket = new DatagramSocket();
        datagramSocket.setBroadcast(true);
        publishMessage = announcement();
        publishPacket = new DatagramPacket(publishMessage, publishMessage.length, InetAddress.getByAddress(BROADCAST),
                PUBLISH_PORT);
        publisher = new Publisher();
        publisher.setDaemon(true);
        publisher.start();
        listener = new Listener();
        listener.setDaemon(true);
        listener.start();
    }

    private byte[] announcement() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeUTF(host);
        out.writeInt(ss.getLocalPort());
        out.writeUTF(name);
        out.writeInt(sampleSize);
        out.writeFloat(frequency);
        return bytes.toByteArray();
    }

    /** Fetches a sample and sends it to all subscribers; one that cannot be reached any more is forgotten. */
    @Override
    public void fetchSample(float[] sample, int offset) {
        super.fetchSample(sample, offset);
        System.arraycopy(sample, offset, latest, 0, sampleSize);
        synchronized (subscribers) {
            subscribers.removeIf(subscriber -> !send(subscriber));
        }
    }

    private boolean send(Socket subscriber) {
        try {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            DataOutputStream out = new DataOutputStream(bytes);
            out.writeLong(System.currentTimeMillis());
            out.writeUTF(host);
            out.writeUTF(name);
            out.writeInt(sampleSize);
            for (float value : latest) {
                out.writeFloat(value);
            }
            subscriber.getOutputStream().write(bytes.toByteArray());
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    /** Announces the samples. */
    class Publisher extends Thread {
        /** Announces once a second, until the network is gone. */
        @Override
        public void run() {
            while (announce()) {
                Delay.msDelay(UDP_PERIOD);
            }
        }

        /** False if the network is gone for good; a broadcast that a network refuses may be taken by a later one. */
        private boolean announce() {
            try {
                datagramSocket.send(publishPacket);
                return true;
            } catch (IOException e) {
                return !datagramSocket.isClosed();
            }
        }
    }

    /** Takes subscriptions. */
    class Listener extends Thread {
        /** Takes subscriptions, until the network is gone. */
        @Override
        public void run() {
            while (!ss.isClosed()) {
                try {
                    Socket subscriber = ss.accept();
                    synchronized (subscribers) {
                        subscribers.add(subscriber);
                    }
                } catch (SocketTimeoutException e) {
                    Delay.msDelay(NAP_MILLIS);
                } catch (IOException e) {
                    return;
                }
            }
        }
    }
}
