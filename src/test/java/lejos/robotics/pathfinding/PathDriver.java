package lejos.robotics.pathfinding;

import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;

/** Finds paths among random walls. */
final class PathDriver {
    private PathDriver() {}

    static Map<String, Double> play(int seed) {
        Sightings seen = new Sightings();
        Random random = new Random(seed);
        Pose start = new Pose(2, 3, 0);
        Waypoint goal = new Waypoint(195, 97, 45);
        ShortestPathFinder shortest = new ShortestPathFinder(walls(random));
        shortest.lengthenLines(random.nextInt(3));
        note(seen, "shortest", shortest, start, goal);
        seen.note("iterations", shortest.getIterationCount()).note("nodes", shortest.getNodeCount());
        note(seen, "back", shortest, goal.getPose(), new Waypoint(start));
        seen.note("more iterations", shortest.getIterationCount());
        mesh(seen, new FourWayGridMesh(walls(random), 10 + random.nextInt(10), random.nextInt(4)), start, goal);
        return seen;
    }

    private static void mesh(Sightings seen, FourWayGridMesh mesh, Pose start, Waypoint goal) {
        int links = 0;
        for (Node node : mesh.getMesh()) {
            links += node.neighbors();
        }
        seen.note("mesh", mesh.getMesh().size()).note("links", links);
        NodePathFinder finder = new NodePathFinder(new AstarSearchAlgorithm(), mesh);
        try {
            Path path = finder.findRoute(start, goal);
            seen.note("grid end", path.get(path.size() - 1).x).note("grid start", path.get(0).y);
        } catch (DestinationUnreachableException e) {
            seen.note("grid unreachable", 1);
        }
    }

    private static void note(Sightings seen, String label, PathFinder finder, Pose start, Waypoint goal) {
        try {
            Path path = finder.findRoute(start, goal);
            seen.note(label + " length", length(path)).note(label + " points", path.size());
            for (int i = 0; i < path.size(); i++) {
                seen.note(label + i, path.get(i).x + 1000 * path.get(i).y);
            }
            seen.note(label + " heading", path.get(path.size() - 1).isHeadingRequired());
        } catch (DestinationUnreachableException e) {
            seen.note(label + " unreachable", 1);
        }
    }

    static double length(Path path) {
        double length = 0;
        for (int i = 1; i < path.size(); i++) {
            length += path.get(i).distance(path.get(i - 1));
        }
        return length;
    }

    static LineMap walls(Random random) {
        Line[] lines = new Line[6];
        for (int i = 0; i < lines.length; i++) {
            float x = 20 + random.nextFloat() * 160;
            float y = 10 + random.nextFloat() * 80;
            lines[i] = new Line(x, y, x + random.nextFloat() * 60 - 30, y + random.nextFloat() * 60 - 30);
        }
        return new LineMap(lines, new Rectangle(0, 0, 200, 100));
    }
}
