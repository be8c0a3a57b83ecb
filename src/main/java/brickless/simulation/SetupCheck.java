package brickless.simulation;

import brickless.kernel.BackendChoice;
import brickless.physics.Arena;
import brickless.world.World;
import brickless.world.Zone;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Whether goal, stimuli and back-end fit the world, its robots and this JVM; checked before anything is written. */
final class SetupCheck {
    private final SimulationSettings settings;
    private final World world;

    SetupCheck(SimulationSettings settings) {
        this.settings = settings;
        world = settings.world();
    }

    /** Throws a {@link SetupException} that names what is wrong and what is there. */
    void check(Arena arena) {
        if (settings.backend() == BackendChoice.CONTINUATIONS && !BackendChoice.continuationsAvailable()) {
            throw new SetupException("the continuation back-end needs JDK 21 or later, started with "
                    + BackendChoice.CONTINUATION_OPTIONS);
        }
        settings.goal().flatMap(Goal::zone).ifPresent(this::zone);
        settings.stimuli().forEach(stimulus -> stimulus(stimulus, arena));
    }

    private void zone(String name) {
        List<String> zones = world.zones().stream().map(Zone::name).distinct().toList();
        if (!zones.contains(name)) {
            throw new SetupException("zone:" + name + ": " + worldName() + " has no such zone; "
                    + (zones.isEmpty() ? "it has no zones" : "its zones are " + String.join(", ", zones)));
        }
    }

    /** Checks that what a stimulus names is there. */
    static void stimulus(Stimulus stimulus, Arena arena) {
        if (stimulus instanceof Stimulus.On on) {
            if (arena.robot(on.robot()).isEmpty()) {
                throw new SetupException("stimulus '" + stimulus.text() + "': there is no robot named " + on.robot()
                        + "; there are: " + arena.robots().stream().map(robot -> robot.name())
                        .collect(Collectors.joining(", ")));
            }
            stimulus(on.what(), arena);
            return;
        }
        String target = stimulus instanceof Stimulus.Move move ? move.target()
                : stimulus instanceof Stimulus.Remove remove ? remove.target() : null;
        if (target == null) {
            return;
        }
        boolean robot = arena.robot(target).isPresent() && stimulus instanceof Stimulus.Move;
        boolean movable = arena.obstacle(target).map(obstacle -> obstacle.description().movable()).orElse(false);
        if (!robot && !movable) {
            Stream<String> movables = arena.obstacles().stream().filter(obstacle -> obstacle.description().movable())
                    .map(obstacle -> obstacle.name());
            Stream<String> robots = stimulus instanceof Stimulus.Move ? arena.robots().stream().map(r -> r.name())
                    : Stream.of();
            throw new SetupException("stimulus '" + stimulus.text() + "': there is nothing movable named " + target
                    + "; there are: " + Stream.concat(robots, movables).collect(Collectors.joining(", ")));
        }
    }

    private String worldName() {
        return settings.worldFile().isEmpty() ? world.name() : settings.worldFile();
    }
}
