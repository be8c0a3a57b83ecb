package lejos.robotics.filter;

import java.io.DataInputStream;
import java.io.IOException;
import java.text.DateFormat;
import java.util.Date;
import lejos.robotics.SampleProvider;

/** Samples from the network. */
public class SubscribedProvider implements SampleProvider {
    /** Formats times. */
    protected DateFormat formatter = PublishedSource.timeFormat();

    private final DataInputStream in;
    private final PublishedSource source;
    private String host;
    private String name;
    private long timeStamp;
    private boolean active = true;

    /** Reads samples of a source. */
    public SubscribedProvider(DataInputStream dis, PublishedSource source) {
        this.in = dis;
        this.source = source;
        this.host = source.getHost();
        this.name = source.getName();
    }

    @Override
    public int sampleSize() {
        return source.sampleSize();
    }

    /** Waits for the next sample; at the end of the subscription the array stays as it is. */
    @Override
    public void fetchSample(float[] sample, int offset) {
        try {
            timeStamp = in.readLong();
            host = in.readUTF();
            name = in.readUTF();
            int count = in.readInt();
            for (int i = 0; i < count; i++) {
                sample[offset + i] = in.readFloat();
            }
        } catch (IOException e) {
            active = false;
        }
    }

    /** Where the samples come from. */
    public PublishedSource getSource() {
        return source;
    }

    /** Name of the brick. */
    public String getHost() {
        return host;
    }

    /** Name of the samples. */
    public String getName() {
        return name;
    }

    /** When the last sample was fetched on the brick, in milliseconds by its clock. */
    public long getTimeStamp() {
        return timeStamp;
    }

    /** Whether the subscription has not ended. */
    public boolean isActive() {
        return active;
    }

    /** When the last sample was fetched on the brick, as hours, minutes, seconds and milliseconds. */
    public String getTime() {
        return formatter.format(new Date(timeStamp));
    }
}
