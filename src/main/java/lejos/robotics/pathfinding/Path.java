package lejos.robotics.pathfinding;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import lejos.robotics.Transmittable;
import lejos.robotics.navigation.Waypoint;

/** Waypoints in the order to drive to them. */
public class Path extends ArrayList<Waypoint> implements Transmittable {
    private static final long serialVersionUID = 1L;

    /** A path without waypoints. */
    public Path() {
    }

    /** Writes the number of waypoints and each of them. */
    @Override
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeInt(size());
        for (Waypoint waypoint : this) {
            waypoint.dumpObject(dos);
        }
    }

    @Override
    public void loadObject(DataInputStream dis) throws IOException {
        int count = dis.readInt();
        clear();
        for (int i = 0; i < count; i++) {
            Waypoint waypoint = new Waypoint(0, 0);
            waypoint.loadObject(dis);
            add(waypoint);
        }
    }
}
