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
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The class loaders of a run: robots with the same program share one, unless the program could notice, and later runs
 * of the program use it again. The JVM then has to load and compile everything once.
 */
final class ProgramLoaders implements AutoCloseable {
    /** Whose classes a robot has. */
    enum Sharing {
        /** Its own. */
        NONE,
        /** Those of all robots of the run that run the same program. */
        IN_THE_RUN,
        /** Those, also with earlier and later runs. */
        WITH_OTHER_RUNS
    }

    private static final Logger LOG = LoggerFactory.getLogger(ProgramLoaders.class);

    private final ClassLoader application = Thread.currentThread().getContextClassLoader();
    private final Sharing sharing;
    private final List<RobotClassLoader> open = new ArrayList<>();
    private final Map<List<Path>, RobotClassLoader> shared = new HashMap<>();
    /** Class paths of programs that could notice. */
    private final Set<List<Path>> unshared = new HashSet<>();

    /**
     * For a run of its programs' main methods, or of a body. That may hand objects of the robot to others, who use them
     * when the run is over.
     */
    static ProgramLoaders ofRun(boolean hasBody) {
        boolean once = hasBody || !CompleteExceptions.areGranted();
        return new ProgramLoaders(once ? Sharing.IN_THE_RUN : Sharing.WITH_OTHER_RUNS);
    }

    /** No loaders yet. */
    ProgramLoaders(Sharing sharing) {
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
        RobotClassLoader loader = open(program);
        if (sharing == Sharing.NONE || unshared.contains(program.classPath())) {
            return loader;
        }
        List<String> mainClasses = all.stream().filter(other -> other.classPath().equals(program.classPath()))
                .map(Program::mainClass).toList();
        if (mainClasses.size() > 1) {
            Optional<String> obstacle = SharingObstacles.firstIn(loader, mainClasses);
            if (obstacle.isPresent()) {
                unshared.add(program.classPath());
                LOG.debug("robots with {} have their own classes: {}", program.name(), obstacle.get());
            } else {
                shared.put(program.classPath(), loader);
            }
        }
        return loader;
    }

    private RobotClassLoader open(Program program) {
        try {
            Optional<RobotClassLoader> idle = sharing == Sharing.WITH_OTHER_RUNS
                    ? IdleLoaders.ofTheJvm().take(program, application) : Optional.empty();
            RobotClassLoader loader = idle.isPresent() ? idle.get() : create(program);
            open.add(loader);
            return loader;
        } catch (IOException e) {
            throw new SetupException(e.getMessage());
        }
    }

    private RobotClassLoader create(Program program) throws IOException {
        RobotClassLoader loader = program.classPath().isEmpty()
                ? RobotClassLoader.ofApplication(application, LoadingRules.standard())
                : RobotClassLoader.ofPaths(program.classPath());
        return sharing == Sharing.NONE ? loader : loader.forSeveralRobots();
    }

    /**
     * Closes the programs' jars and leaves the classes to later runs, unless a program could notice. Only after a run
     * that came to its end: nothing of it may still run.
     */
    void giveBack() {
        List<RobotClassLoader> idle = open.stream()
                .filter(loader -> sharing == Sharing.WITH_OTHER_RUNS && isReusable(loader)).toList();
        close();
        idle.forEach(loader -> {
            loader.forget();
            IdleLoaders.ofTheJvm().put(loader);
        });
    }

    private static boolean isReusable(RobotClassLoader loader) {
        Optional<String> obstacle = loader.obstacleToReuse();
        obstacle.ifPresent(reason -> LOG.debug("no other run uses the classes again: {}", reason));
        return obstacle.isEmpty();
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
