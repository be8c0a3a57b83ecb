package brickless.viewer;

import brickless.program.Program;
import brickless.simulation.SimulationSettings;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.OptionalLong;
import java.util.function.Function;

/** What is watched: makes it ready for a run, as often as it is started again. Called by one thread at a time. */
public interface RunSource {
    /**
     * Compiles and reads everything afresh.
     *
     * @param seed another seed than the first run's
     * @throws brickless.simulation.SetupException with a message for the user if that is not possible
     */
    Prepared prepare(OptionalLong seed);

    /**
     * A program and all it needs.
     *
     * @param program closed when its run is over
     * @param settings of the run
     * @param files what it was made of: if one of them changes a restart is offered
     * @param command the command that runs it again headless within a time limit, with the stimuli of a file
     *         {@code stimuli.txt}
     */
    record Prepared(Program program, SimulationSettings settings, List<Path> files,
            Function<Duration, String> command) {
        public Prepared {
            files = List.copyOf(files);
        }
    }
}
