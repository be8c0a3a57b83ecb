package brickless.simulation;

import brickless.kernel.BackendChoice;
import brickless.world.RobotModel;
import brickless.world.World;
import java.io.OutputStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * Everything a run is made of except the program.
 *
 * @param world the arena
 * @param worldFile the world as the user named it; files that the drawing refers to are looked for beside it
 * @param robot the robot for every placement that names none; empty: fitted to the program
 * @param seed seed of noise and of the program's random numbers
 * @param scheduleSeed seed of a random schedule; empty: round-robin
 * @param limit simulated time at which the run ends
 * @param goal what the run is to reach
 * @param ideal whether noise, latency and slip are off
 * @param pressButtons whether keys the program waits for are pressed automatically
 * @param attended whether somebody watches the brick: an exception then waits on its screen for a key
 * @param stimuli what happens to the robots, in order of time
 * @param backend how program threads are carried
 * @param console where the program's output is passed on as it is printed
 * @param out folder for the files of the run; empty: none are written
 */
public record SimulationSettings(World world, String worldFile, Optional<RobotModel> robot, long seed,
        OptionalLong scheduleSeed, Duration limit, Optional<Goal> goal, boolean ideal, boolean pressButtons,
        boolean attended, List<Stimulus> stimuli, BackendChoice backend, OutputStream console, Optional<Path> out) {
    public SimulationSettings {
        stimuli = List.copyOf(stimuli);
    }

    /** Settings with the defaults of the command line. */
    public static Builder builder(World world) {
        return new Builder(world);
    }

    /** A builder that starts from these settings. */
    public Builder toBuilder() {
        Builder builder = new Builder(world).worldFile(worldFile).seed(seed).scheduleSeed(scheduleSeed).limit(limit)
                .goal(goal).ideal(ideal)
                .pressButtons(pressButtons).attended(attended).stimuli(stimuli).backend(backend)
                .console(console).out(out);
        robot.ifPresent(builder::robot);
        return builder;
    }

    /** Collects settings. */
    public static final class Builder {
        private final World world;
        private String worldFile = "";
        private Optional<RobotModel> robot = Optional.empty();
        private long seed = 1;
        private OptionalLong scheduleSeed = OptionalLong.empty();
        private Duration limit = Duration.ofSeconds(60);
        private Optional<Goal> goal = Optional.empty();
        private boolean ideal;
        private boolean pressButtons = true;
        private boolean attended;
        private List<Stimulus> stimuli = List.of();
        private BackendChoice backend = BackendChoice.AUTO;
        private OutputStream console = OutputStream.nullOutputStream();
        private Optional<Path> out = Optional.empty();

        private Builder(World world) {
            this.world = world;
        }

        /** The world as the user named it. */
        public Builder worldFile(String value) {
            worldFile = value;
            return this;
        }

        /** The robot for every placement that names none. */
        public Builder robot(RobotModel value) {
            robot = Optional.of(value);
            return this;
        }

        /** Seed of noise and random numbers. */
        public Builder seed(long value) {
            seed = value;
            return this;
        }

        /** Seed of a random schedule. */
        public Builder scheduleSeed(OptionalLong value) {
            scheduleSeed = value;
            return this;
        }

        /** Simulated time limit. */
        public Builder limit(Duration value) {
            limit = value;
            return this;
        }

        /** What the run is to reach. */
        public Builder goal(Optional<Goal> value) {
            goal = value;
            return this;
        }

        /** Switches noise, latency and slip off. */
        public Builder ideal(boolean value) {
            ideal = value;
            return this;
        }

        /** Whether keys the program waits for are pressed automatically. */
        public Builder pressButtons(boolean value) {
            pressButtons = value;
            return this;
        }

        /** Whether somebody watches the brick and can press keys. */
        public Builder attended(boolean value) {
            attended = value;
            return this;
        }

        /** What happens to the robots. */
        public Builder stimuli(List<Stimulus> value) {
            stimuli = value;
            return this;
        }

        /** How program threads are carried. */
        public Builder backend(BackendChoice value) {
            backend = value;
            return this;
        }

        /** Where the program's output is passed on. */
        public Builder console(OutputStream value) {
            console = value;
            return this;
        }

        /** Folder for the files of the run. */
        public Builder out(Optional<Path> value) {
            out = value;
            return this;
        }

        /** The settings. */
        public SimulationSettings build() {
            return new SimulationSettings(world, worldFile, robot, seed, scheduleSeed, limit, goal, ideal, pressButtons,
                    attended, stimuli, backend, console, out);
        }
    }
}
