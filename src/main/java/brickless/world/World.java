package brickless.world;

import java.util.List;
import java.util.Optional;

/**
 * An arena as drawn.
 *
 * @param name file name without extension
 * @param minX left edge of the drawing, metres
 * @param minY top edge of the drawing, metres
 * @param width width of the drawing, metres
 * @param height height of the drawing, metres
 * @param floor what lies on the floor, bottom first
 * @param obstacles solid things
 * @param zones named areas
 * @param beacons infrared beacons
 * @param lamps light sources
 * @param table the surface robots may stand on; outside is a drop. Empty: no drop anywhere
 * @param placements robots, in drawing order
 * @param svg the drawing's text with its images embedded, for pictures of a run
 * @param ambientLux light of the room everywhere on the floor, without any lamp
 */
public record World(String name, double minX, double minY, double width, double height, List<Paint> floor,
        List<Obstacle> obstacles, List<Zone> zones, List<Beacon> beacons, List<Lamp> lamps, Optional<Region> table,
        List<Placement> placements, String svg, double ambientLux) {
    /** Light of a room that says nothing else: assumption, a living room. */
    public static final double LIVING_ROOM_LUX = 100;

    public World {
        floor = List.copyOf(floor);
        obstacles = List.copyOf(obstacles);
        zones = List.copyOf(zones);
        beacons = List.copyOf(beacons);
        lamps = List.copyOf(lamps);
        placements = List.copyOf(placements);
    }

    /** An arena in the light of a living room. */
    public World(String name, double minX, double minY, double width, double height, List<Paint> floor,
            List<Obstacle> obstacles, List<Zone> zones, List<Beacon> beacons, List<Lamp> lamps, Optional<Region> table,
            List<Placement> placements, String svg) {
        this(name, minX, minY, width, height, floor, obstacles, zones, beacons, lamps, table, placements, svg,
                LIVING_ROOM_LUX);
    }
}
