package lejos.robotics.objectdetection;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;
import lejos.robotics.Transmittable;
import lejos.robotics.navigation.Pose;

/** Objects found by their distance, and where the robot was then. */
public class RangeFeature implements Feature, Transmittable {
    private RangeReading nearest;
    private RangeReadings readings;
    private Pose pose;
    private long timeStamp = System.currentTimeMillis();

    /** One object. */
    public RangeFeature(RangeReading rr) {
        nearest = rr;
        pose = new Pose();
    }

    /** Several objects, nearest first. */
    public RangeFeature(RangeReadings rrs) {
        this(rrs, new Pose());
    }

    /**
     * Several objects, nearest first, seen from a pose.
     *
     * @throws IndexOutOfBoundsException if there is none
     */
    public RangeFeature(RangeReadings rrs, Pose pose) {
        this.readings = rrs;
        this.nearest = rrs.get(0);
        this.pose = pose;
    }

    @Override
    public RangeReading getRangeReading() {
        return nearest;
    }

    @Override
    public long getTimeStamp() {
        return timeStamp;
    }

    @Override
    public RangeReadings getRangeReadings() {
        if (readings == null) {
            readings = new RangeReadings(0);
            readings.add(nearest);
        }
        return readings;
    }

    /** Where the robot was; the origin if not known. */
    public Pose getPose() {
        return pose;
    }

    /** Writes the pose, the distance of the nearest object and the time. */
    @Override
    public void dumpObject(DataOutputStream dos) throws IOException {
        pose.dumpObject(dos);
        dos.writeFloat(nearest.getRange());
        dos.writeLong(timeStamp);
        dos.flush();
    }

    /** Reads what {@link #dumpObject} wrote; the angle is not among it and becomes 0. */
    @Override
    public void loadObject(DataInputStream dis) throws IOException {
        pose.loadObject(dis);
        nearest = new RangeReading(0, dis.readFloat());
        readings = null;
        timeStamp = dis.readLong();
    }
}
