package lejos.robotics;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;

/** The readings of one scan, in the order of its angles. */
public class RangeReadings extends ArrayList<RangeReading> implements Transmittable {
    private static final long serialVersionUID = 1L;
    private static final float INVALID = -1;

    /** As many invalid readings at angle zero as asked for. */
    public RangeReadings(int numReadings) {
        for (int i = 0; i < numReadings; i++) {
            add(new RangeReading(0, INVALID));
        }
    }

    /** Distance of a reading by its number. */
    public float getRange(int i) {
        return get(i).getRange();
    }

    /** Distance of the first reading at exactly this angle in degrees; −1 if there is none. */
    public float getRange(float angle) {
        for (RangeReading reading : this) {
            if (reading.getAngle() == angle) {
                return reading.getRange();
            }
        }
        return INVALID;
    }

    /** Angle of a reading in degrees. */
    public float getAngle(int index) {
        return get(index).getAngle();
    }

    /** Whether any reading is invalid; false if there are none. */
    public boolean incomplete() {
        return stream().anyMatch(RangeReading::invalidReading);
    }

    /** Number of readings. */
    public int getNumReadings() {
        return size();
    }

    /** Replaces a reading. */
    public void setRange(int index, float angle, float range) {
        set(index, new RangeReading(angle, range));
    }

    /** Writes the number of readings, then angle and range of each. */
    @Override
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeInt(size());
        for (RangeReading reading : this) {
            dos.writeFloat(reading.getAngle());
            dos.writeFloat(reading.getRange());
        }
        dos.flush();
    }

    @Override
    public void loadObject(DataInputStream dis) throws IOException {
        int count = dis.readInt();
        clear();
        for (int i = 0; i < count; i++) {
            float angle = dis.readFloat();
            add(new RangeReading(angle, dis.readFloat()));
        }
    }

    /** Prints one line per reading. */
    public void printReadings() {
        int number = 0;
        for (RangeReading reading : this) {
            String range = reading.invalidReading() ? "Invalid" : Float.toString(reading.getRange());
            System.out.println("Range " + number++ + " = " + range);
        }
    }
}
