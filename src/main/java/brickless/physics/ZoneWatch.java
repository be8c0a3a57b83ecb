package brickless.physics;

import brickless.world.Region;
import brickless.world.Zone;
import java.util.List;

/** Tells which robots enter and leave which zones. */
final class ZoneWatch {
    private final List<Zone> zones;
    private final double[][] bounds;
    private final boolean[][] inside;

    ZoneWatch(List<Zone> zones, int robots) {
        this.zones = zones;
        this.bounds = zones.stream().map(Zone::region).map(Region::bounds).toArray(double[][]::new);
        this.inside = new boolean[robots][zones.size()];
    }

    void check(RobotBody robot, ArenaListener listener) {
        boolean[] known = inside[robot.index];
        for (int i = 0; i < known.length; i++) {
            boolean now = within(i, robot.xMetres(), robot.yMetres());
            if (now != known[i]) {
                known[i] = now;
                if (now) {
                    listener.zoneEntered(robot, zones.get(i).name());
                } else {
                    listener.zoneLeft(robot, zones.get(i).name());
                }
            }
        }
    }

    private boolean within(int zone, double x, double y) {
        double[] box = bounds[zone];
        return x >= box[0] && y >= box[1] && x <= box[2] && y <= box[3] && zones.get(zone).region().contains(x, y);
    }
}
