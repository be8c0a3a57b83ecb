package lejos.robotics.filter;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.Socket;
import java.text.DateFormat;
import java.text.SimpleDateFormat;
import java.util.Collection;
import java.util.Date;
import java.util.Locale;
import java.util.TimeZone;

/** Samples that some brick on the network publishes with a {@link PublishFilter}. */
public class PublishedSource {
    /** Greatest length of an announcement in bytes. */
    protected static final int MAX_PACKET_SIZE = 64;
    /** UDP port on which samples are announced. */
    protected static final int PUBLISH_PORT = 3017;
    /** Milliseconds that {@link #getSources} listens. */
    protected static final int SOCKET_TIMEOUT = 3000;
    /** Milliseconds after which samples that are not announced again count as gone. */
    protected static final int MAX_AGE = 10000;
    /** Greatest length of a sample in bytes. */
    protected static final int MAX_SAMPLE_MESSAGE_SIZE = 128;

    /** Name of the samples. */
    protected String name;
    /** Number of values of a sample. */
    protected int sampleSize;
    /** A sample. */
    protected float[] sample;
    /** How often samples are fetched, in hertz. */
    protected float frequency;
    /** Name of the brick. */
    protected String host;
    /** TCP port to subscribe at. */
    protected int port;
    /** When the samples were announced last, in milliseconds. */
    protected long timeStamp;
    /** Formats times. */
    protected DateFormat formatter = timeFormat();
    /** Address of the brick. */
    protected String ipAddress;
    /** The subscription; null before {@link #connect}. */
    protected Socket socket;
    /** What comes from the brick; null before {@link #connect}. */
    protected DataInputStream dis;

    /**
     * Reads an announcement.
     *
     * @param ipAddress where it came from
     * @param message what it says
     * @throws IOException if it is no announcement
     */
    public PublishedSource(String ipAddress, byte[] message) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(message));
        this.ipAddress = ipAddress;
        this.host = in.readUTF();
        this.port = in.readInt();
        this.name = in.readUTF();
        this.sampleSize = in.readInt();
        this.frequency = in.readFloat();
        this.sample = new float[sampleSize];
        this.timeStamp = System.currentTimeMillis();
    }

    static DateFormat timeFormat() {
        DateFormat format = new SimpleDateFormat("HH:mm:ss:SSS", Locale.ROOT);
        format.setTimeZone(TimeZone.getTimeZone("UTC"));
        return format;
    }

    /**
     * Subscribes.
     *
     * @throws IOException if the brick cannot be reached
     */
    public SubscribedProvider connect() throws IOException {
        socket = new Socket(ipAddress, port);
        dis = new DataInputStream(socket.getInputStream());
        return new SubscribedProvider(dis, this);
    }

    /** Number of values of a sample. */
    public int sampleSize() {
        return sampleSize;
    }

    /** Name of the samples. */
    public String getName() {
        return name;
    }

    /** How often samples are fetched, in hertz. */
    public float getFrequency() {
        return frequency;
    }

    /** Name of the brick. */
    public String getHost() {
        return host;
    }

    /** When the samples were announced last, as hours, minutes, seconds and milliseconds. */
    public String getTime() {
        return formatter.format(new Date(timeStamp));
    }

    /** What tells these samples from others: brick and port. */
    public String getKey() {
        return host + ":" + port;
    }

    /** Address of the brick. */
    public String getIpAddress() {
        return ipAddress;
    }

    /** TCP port to subscribe at. */
    public int getPort() {
        return port;
    }

    /** When the samples were announced last, in milliseconds. */
    public long getTimeStamp() {
        return timeStamp;
    }

    /**
     * Ends the subscription.
     *
     * @throws IOException if the network fails
     */
    public void close() throws IOException {
        if (socket != null) {
            socket.close();
        }
    }

    /** All samples that are announced; listens for 3 seconds. */
    public static Collection<PublishedSource> getSources() {
        return Announcements.hear(PUBLISH_PORT, MAX_PACKET_SIZE, SOCKET_TIMEOUT, MAX_AGE);
    }
}
