package lejos.robotics.pathfinding;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lejos.Agreement;
import lejos.robotics.RangeReadings;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class PathFinderTest {
    private static final Rectangle AREA = new Rectangle(-10, -50, 200, 100);

    private final Pose start = new Pose();
    private final Waypoint goal = new Waypoint(100, 0);
    private final LineMap wall = new LineMap(new Line[] {new Line(50, -20, 50, 20)}, AREA);
    private final LineMap box = new LineMap(
            new Line[] {new Line(-5, -5, 5, -5), new Line(5, -5, 5, 5), new Line(5, 5, -5, 5),
        new Line(-5, 5, -5, -5)}, AREA);

    @BeforeEach
    void chooseTheSeed() {
        RandomPathFinder.RANDOM.setSeed(1);
        RandomSelfGeneratingNode.RANDOM.setSeed(2);
    }

    @Test
    void pathsAreThoseOfThePublishedFinders() {
        Agreement.check(PathDriver.class, 2000, 2e-4, PathDriver::play);
    }

    @Test
    void shortestPathGoesAroundTheEndOfAWall() throws DestinationUnreachableException {
        ShortestPathFinder finder = new ShortestPathFinder(wall);
        assertThat(finder.findRoute(start, goal)).containsExactly(new Waypoint(0, 0), new Waypoint(50, -20), goal);
        assertThat(finder.getIterationCount()).isEqualTo(4);
        assertThat(finder.getNodeCount()).isEqualTo(4);
    }

    @Test
    void lengthenedWallsLeaveNoWayOutOfABox() throws DestinationUnreachableException {
        ShortestPathFinder finder = new ShortestPathFinder(box);
        assertThat(finder.findRoute(start, goal)).as("through the corner").hasSize(3);
        finder.lengthenLines(1);
        assertThatThrownBy(() -> finder.findRoute(start, goal)).isInstanceOf(DestinationUnreachableException.class);
    }

    @Test
    void dijkstraFindsPathsAsShortAsTheShortest() throws DestinationUnreachableException {
        for (int index = 0; index < 300; index++) {
            LineMap map = PathDriver.walls(new Random(index));
            Pose from = new Pose(2, 3, 0);
            Waypoint to = new Waypoint(195, 97);
            Path shortest = new ShortestPathFinder(map).findRoute(from, to);
            Path found = new DijkstraPathFinder(map).findRoute(from, to);
            assertThat(PathDriver.length(found)).as("walls " + index)
                    .isCloseTo(PathDriver.length(shortest), within(0.01));
        }
    }

    @Test
    void dijkstraGivesUpWhereThereIsNoWay() {
        DijkstraPathFinder finder = new DijkstraPathFinder(box);
        finder.lengthenLines(1);
        assertThatThrownBy(() -> finder.findRoute(start, goal)).isInstanceOf(DestinationUnreachableException.class);
    }

    @Test
    void unreachableDestinationTellsListenersNothing() {
        ShortestPathFinder finder = new ShortestPathFinder(box);
        finder.lengthenLines(1);
        NodePathFinder grid = new NodePathFinder(new AstarSearchAlgorithm(), new FourWayGridMesh(box, 3, 1));
        RandomPathFinder random = new RandomPathFinder(box, new RangeReadings(1));
        for (PathFinder each : List.of(finder, grid, random)) {
            Told told = new Told();
            each.addListener(told);
            each.startPathFinding(start, goal);
            assertThat(told.points).as(each.getClass().getSimpleName()).isEmpty();
            assertThat(told.complete).isZero();
        }
    }

    @Test
    void listenersAreToldEveryPointOfAPath() {
        ShortestPathFinder finder = new ShortestPathFinder(wall);
        Told told = new Told();
        finder.addListener(told);
        finder.startPathFinding(start, goal);
        assertThat(told.points).containsExactly(new Waypoint(0, 0), new Waypoint(50, -20), goal);
        assertThat(told.complete).isEqualTo(1);
    }

    @Test
    void gridHasANodeInEachFieldWithClearance() {
        FourWayGridMesh mesh = new FourWayGridMesh(new LineMap(new Line[0], AREA), 10, 5);
        assertThat(mesh.getMesh()).hasSize(171);
        assertThat(mesh.getMesh().iterator().next().neighbors()).isEqualTo(2);
    }

    @Test
    void gridIsUnchangedAfterASearchThatFails() {
        FourWayGridMesh mesh = new FourWayGridMesh(box, 3, 1);
        int size = mesh.getMesh().size();
        NodePathFinder finder = new NodePathFinder(new AstarSearchAlgorithm(), mesh);
        assertThatThrownBy(() -> finder.findRoute(start, goal)).isInstanceOf(DestinationUnreachableException.class);
        assertThat(mesh.getMesh()).hasSize(size);
    }

    @Test
    void nodesOfAllGridsShareTheLastSpacing() {
        GridNode first = new GridNode(0, 0, 10);
        GridNode second = new GridNode(30, 40, 7);
        assertThat(first.calculateG(second)).as("as in leJOS, static").isEqualTo(7);
        assertThat(first.calculateH(second)).isEqualTo(70);
        assertThat(new Node(0, 0).calculateG(second)).isEqualTo(50);
    }

    @Test
    void linksAreOneWay() {
        Node first = new Node(0, 0);
        Node second = new Node(1, 1);
        assertThat(first.addNeighbor(second)).isTrue();
        assertThat(first.addNeighbor(second)).isFalse();
        assertThat(first.addNeighbor(first)).isFalse();
        assertThat(second.neighbors()).isZero();
        assertThat(first.getNeighbors()).containsExactly(second);
        assertThat(first.removeNeighbor(second)).isTrue();
        assertThat(first.removeNeighbor(second)).isFalse();
    }

    @Test
    void mapsGivenLaterAreAddedAndListsReplace() throws DestinationUnreachableException {
        ShortestPathFinder finder = new ShortestPathFinder(wall);
        finder.setMap(box);
        assertThat(finder.getMap()).as("as in leJOS").hasSize(5);
        finder.setMap(new ArrayList<>());
        assertThat(finder.findRoute(start, goal)).hasSize(2);
        finder.lengthenLines(5);
        new ShortestPathFinder(wall).lengthenLines(5);
        assertThat(wall.getLines()[0].length()).as("the map's own lines").isEqualTo(50);
    }

    @Test
    void linksOfAGridCanBeCutAndMade() {
        FourWayGridMesh mesh = new FourWayGridMesh(wall, 10, 2);
        Node first = mesh.getMesh().iterator().next();
        Node second = first.getNeighbors().iterator().next();
        assertThat(mesh.disconnect(first, second)).isTrue();
        assertThat(first.getNeighbors()).doesNotContain(second);
        assertThat(mesh.disconnect(first, second)).as("always").isTrue();
        assertThat(mesh.connect(first, second)).isTrue();
        assertThat(mesh.connect(first, second)).as("linked already").isTrue();
        assertThat(mesh.connect(new Node(45, 0), new Node(55, 0))).as("through the wall").isFalse();
        assertThat(mesh.connect(first, new Node(-11, 0))).as("outside").isFalse();
    }

    @Test
    void aStarPrefersTheCheaperWayFoundLater() {
        Node first = new Node(0, 0);
        Node detour = new Node(0, 8);
        Node direct = new Node(5, 0);
        Node last = new Node(10, 0);
        first.addNeighbor(detour);
        first.addNeighbor(direct);
        detour.addNeighbor(last);
        direct.addNeighbor(last);
        assertThat(new AstarSearchAlgorithm().findPath(first, last))
                .containsExactly(new Waypoint(0, 0), new Waypoint(5, 0), new Waypoint(10, 0));
        assertThat(new AstarSearchAlgorithm().findPath(last, first)).isNull();
    }

    @Test
    void selfGeneratingNodesReachTheirGoal() {
        Node goalNode = new Node(30, 30);
        Node startNode = new RandomSelfGeneratingNode(0, 0, 20, 8, goalNode);
        Path path = new AstarSearchAlgorithm().findPath(startNode, goalNode);
        assertThat(path.get(0)).isEqualTo(new Waypoint(0, 0));
        assertThat(path.get(path.size() - 1)).isEqualTo(new Waypoint(30, 30));
    }

    /** A random walk may end in a corner from which nothing is nearer: it is made again, but not for ever. */
    private static Path foundByChance(RandomPathFinder finder, Pose from, Waypoint destination)
            throws DestinationUnreachableException {
        for (int attempt = 1; attempt < 200; attempt++) {
            try {
                return finder.findRoute(from, destination);
            } catch (DestinationUnreachableException corner) {
                assertThat(from.getHeading()).as("after attempt %d", attempt).isEqualTo(77);
            }
        }
        return finder.findRoute(from, destination);
    }

    @Test
    void randomPathLeavesTheStartPoseAlone() throws DestinationUnreachableException {
        LineMap room = new LineMap(new Line[] {new Line(0, 0, 200, 0), new Line(200, 0, 200, 100),
                new Line(200, 100, 0, 100),
            new Line(0, 100, 0, 0), new Line(100, 0, 100, 60)}, new Rectangle(0, 0, 200, 100));
        RandomPathFinder finder = new RandomPathFinder(room, new RangeReadings(2));
        Pose from = new Pose(30, 30, 77);
        Path path = foundByChance(finder, from, new Waypoint(170, 30));
        assertThat(from.getHeading()).isEqualTo(77);
        assertThat(path.size()).isGreaterThanOrEqualTo(2);
        assertThat(path.get(0).isHeadingRequired()).isTrue();
        assertThat(path.get(path.size() - 1)).isEqualTo(new Waypoint(170, 30));
    }

    private static final class Told implements WaypointListener {
        private final List<Waypoint> points = new ArrayList<>();
        private int complete;

        @Override
        public void addWaypoint(Waypoint wp) {
            points.add(wp);
        }

        @Override
        public void pathGenerated() {
            complete++;
        }
    }
}
