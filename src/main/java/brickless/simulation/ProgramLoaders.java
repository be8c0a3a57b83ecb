package brickless.simulation;

import brickless.loading.LoadingRules;
import brickless.loading.RobotClassLoader;
import brickless.loading.RobotContext;
import brickless.loading.SharingObstacles;
import brickless.program.Program;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The class loaders of a run: robots with the same program share one, unless the program could notice. The JVM then has
 * to load and compile everything once.
 */
final class ProgramLoaders implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ProgramLoaders.class);

    private final ClassLoader application = Thread.currentThread().getContextClassLoader();
    private final boolean sharing;
    private final List<RobotClassLoader> open = new ArrayList<>();
    private final Map<List<Path>, RobotClassLoader> shared = new HashMap<>();

    /**
     * No loaders yet.
     *
     * @param sharing whether robots may share; else each has a loader of its own
     */
    ProgramLoaders(boolean sharing) {
        this.sharing = sharing;
    }

    /** Contexts for the robots of a crew, in their order. */
    List<RobotContext> contexts(List<Program> programs) {
        return programs.stream().map(program -> loaderFor(program, programs).newRobot()).toList();
    }

    private RobotClassLoader loaderFor(Program program, List<Program> all) {
        RobotClassLoader known = shared.get(program.classPath());
        if (known != null) {
            return known;
        }
        List<String> mainClasses = all.stream().filter(other -> other.classPath().equals(program.classPath()))
                .map(Program::mainClass).toList();
        RobotClassLoader loader = open(program);
        if (sharing && mainClasses.size() > 1) {
            Optional<String> obstacle = SharingObstacles.firstIn(loader, mainClasses);
            if (obstacle.isPresent()) {
                LOG.debug("robots with {} have their own classes: {}", program.name(), obstacle.get());
            } else {
                shared.put(program.classPath(), loader.forSeveralRobots());
            }
        }
        return loader;
    }

    private RobotClassLoader open(Program program) {
        try {
            RobotClassLoader loader = program.classPath().isEmpty()
                    ? RobotClassLoader.ofApplication(application, LoadingRules.standard())
                    : RobotClassLoader.ofPaths(program.classPath());
            open.add(loader);
            return loader;
        } catch (IOException e) {
            throw new SetupException(e.getMessage());
        }
    }

    /** Closes the programs' jars. */
    @Override
    public void close() {
        for (RobotClassLoader loader : open) {
            try {
                loader.close();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
        open.clear();
        shared.clear();
    }
}
