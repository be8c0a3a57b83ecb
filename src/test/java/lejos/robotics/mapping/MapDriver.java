package lejos.robotics.mapping;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Random;
import javax.xml.stream.XMLStreamException;
import lejos.Agreement.Sightings;
import lejos.Bytes;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Point;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.navigation.Pose;

/** Asks maps everything. */
final class MapDriver {
    private MapDriver() {}

    static Map<String, Double> play(int seed) {
        Random random = new Random(seed);
        Sightings seen = new Sightings();
        LineMap map = room(random, seed % 2 == 0);
        for (int i = 0; i < 20; i++) {
            Point p = new Point(random.nextFloat() * 240 - 20, random.nextFloat() * 140 - 20);
            if (seed % 2 == 1) {
                seen.note("inside " + i, map.inside(p));
            }
            seen.note("range " + i, map.range(new Pose(p.x, p.y, random.nextFloat() * 720 - 360)));
        }
        Bytes.note(seen, "map", map);
        LineMap flipped = Bytes.copy(map, new LineMap()).flip();
        Bytes.note(seen, "flipped", flipped);
        Bytes.note(seen, "drawn", drawn(map));
        grid(seen, random);
        for (NavigationModel.NavEvent event : NavigationModel.NavEvent.values()) {
            seen.note("code of " + event, event.ordinal());
        }
        return seen;
    }

    /**
     * Four outer walls and three within; the published class judges insides by luck if those are not parallel to an
     * axis.
     */
    private static LineMap room(Random random, boolean sloped) {
        Line[] lines = new Line[7];
        lines[0] = new Line(0, 0, 200, 0);
        lines[1] = new Line(200, 0, 200, 100);
        lines[2] = new Line(200, 100, 0, 100);
        lines[3] = new Line(0, 100, 0, 0);
        for (int i = 4; i < lines.length; i++) {
            float x = random.nextFloat() * 180 + 10;
            float y = random.nextFloat() * 80 + 10;
            float otherX = random.nextFloat() * 180 + 10;
            float otherY = random.nextFloat() * 80 + 10;
            lines[i] = new Line(x, y, sloped || i == 4 ? otherX : x, sloped || i != 4 ? otherY : y);
        }
        return new LineMap(lines, new Rectangle(0, 0, 200, 100));
    }

    private static LineMap drawn(LineMap map) {
        StringBuilder svg = new StringBuilder("<svg xmlns='http://www.w3.org/2000/svg'><g><rect x='7'/>");
        for (Line line : map.getLines()) {
            svg.append("<line x1='" + line.x1 + "' y1='" + line.y1 + "' x2='" + line.x2 + "' y2='" + line.y2 + "'/>");
        }
        svg.append("</g></svg>");
        try {
            return new SVGMapLoader(new ByteArrayInputStream(svg.toString().getBytes(StandardCharsets.UTF_8)))
                    .readLineMap();
        } catch (XMLStreamException e) {
            throw new AssertionError(e);
        }
    }

    private static void grid(Sightings seen, Random random) {
        OccupancyGridMap grid = new OccupancyGridMap(4, 3, 40, 60, 2.5);
        seen.note("size", grid.getWidth() * 10 + grid.getHeight() + grid.getResolution());
        seen.note("thresholds", grid.getFreeThreshold() * 1000 + grid.getOccupiedThreshold());
        for (int i = 0; i < 12; i++) {
            grid.setOccupied(i % 4, i % 3, random.nextInt(400));
            seen.note("value " + i, grid.getOccupied(i % 4, i % 3));
            seen.note("occupied " + i, grid.isOccupied(i % 4, i % 3)).note("free " + i, grid.isFree(i % 4, i % 3));
        }
    }
}
