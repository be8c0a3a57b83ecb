package brickless.bench;

import brickless.TestWorlds;
import brickless.physics.Entrant;
import brickless.world.Obstacle;
import brickless.world.Placement;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import brickless.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A walled square with any number of robots in rows and columns, a crate beside each. */
record RobotGrid(int robots) {
    /** Distance of neighbours, metres. */
    static final double CELL = 1.5;
    static final double WALL = 0.03;
    static final double CRATE = 0.15;
    /** Where a crate is, from its robot, metres in both directions. */
    static final double CRATE_AWAY = 0.6;
    static final double CRATE_KILOGRAMS = 0.5;

    int columns() {
        return (int) Math.ceil(Math.sqrt(robots));
    }

    /** Length of a side, metres. */
    double side() {
        return columns() * CELL;
    }

    Point2 place(int robot) {
        return new Point2((robot % columns() + 0.5) * CELL, (robot / columns() + 0.5) * CELL);
    }

    World world() {
        double side = side();
        List<Obstacle> obstacles = new ArrayList<>(List.of(TestWorlds.wall("north", 0, -WALL, side, 0),
                TestWorlds.wall("south", 0, side, side, side + WALL), TestWorlds.wall("west", -WALL, 0, 0, side),
                TestWorlds.wall("east", side, 0, side + WALL, side)));
        List<Placement> placements = new ArrayList<>();
        for (int i = 0; i < robots; i++) {
            Point2 place = place(i);
            obstacles.add(TestWorlds.crate("crate" + i, place.x() + CRATE_AWAY, place.y() + CRATE_AWAY, CRATE,
                    CRATE_KILOGRAMS));
            placements.add(new Placement("robot" + i, new Pose2(place.x(), place.y(), 0), Optional.empty(),
                    Optional.empty()));
        }
        return new World("grid", -WALL, -WALL, side + 2 * WALL, side + 2 * WALL, List.of(), obstacles, List.of(),
                List.of(), List.of(), Optional.empty(), placements, "");
    }

    List<Entrant> entrants() {
        return world().placements().stream().map(place -> new Entrant(place.name(), model(), place.start())).toList();
    }

    /** Two motors, a touch and an ultrasonic sensor. */
    static RobotModel model() {
        return TestWorlds.educator(
                new SensorMount("bumper", 0, SensorType.EV3_TOUCH, new Point2(0.06, 0), 0, 0.03,
                        TestWorlds.box(0.055, -0.058, 0.065, 0.058), Optional.empty()),
                new SensorMount("eye", 3, SensorType.EV3_ULTRASONIC, new Point2(0.05, 0), 0, 0.06, List.of(),
                        Optional.empty()));
    }
}
