package brickless.simulation;

import brickless.physics.ArenaListener;
import brickless.physics.RobotBody;
import brickless.physics.Solid;
import brickless.trace.TraceEvent;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;

/**
 * What happens to the robots in the arena: collisions, zones, falls. Writes it into the trace and remembers it for the
 * report.
 */
final class Journey implements ArenaListener {
    private final Recorder recorder;
    private final LongSupplier clock;
    private final Set<String> zones = new LinkedHashSet<>();
    private final Optional<String> goalZone;
    private int collisions;
    private boolean goalReached;
    private String fallen = "";

    Journey(Recorder recorder, LongSupplier clock, Optional<String> goalZone) {
        this.recorder = recorder;
        this.clock = clock;
        this.goalZone = goalZone;
    }

    @Override
    public void collision(Solid hitter, Solid hit, double speedMetresPerSecond) {
        collisions++;
        Solid robot = hitter instanceof RobotBody ? hitter : hit;
        Solid other = robot == hitter ? hit : hitter;
        recorder.event(clock.getAsLong(), robot.name(),
                new TraceEvent.CollisionEvent(other.name(), speedMetresPerSecond));
    }

    @Override
    public void zoneEntered(RobotBody robot, String zone) {
        zones.add(zone);
        goalReached |= goalZone.isPresent() && goalZone.get().equals(zone);
        recorder.event(clock.getAsLong(), robot.name(), new TraceEvent.ZoneEvent(zone, true));
    }

    @Override
    public void zoneLeft(RobotBody robot, String zone) {
        recorder.event(clock.getAsLong(), robot.name(), new TraceEvent.ZoneEvent(zone, false));
    }

    @Override
    public void fell(RobotBody robot) {
        if (fallen.isEmpty()) {
            fallen = robot.name();
        }
        recorder.event(clock.getAsLong(), robot.name(), new TraceEvent.FallEvent());
    }

    int collisions() {
        return collisions;
    }

    Set<String> zones() {
        return zones;
    }

    boolean goalReached() {
        return goalReached;
    }

    /** Name of the robot that fell off the table first, empty if none. */
    String fallen() {
        return fallen;
    }
}
