package brickless.cli;

import brickless.kernel.BackendChoice;
import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFinder;
import brickless.simulation.Durations;
import brickless.simulation.Goal;
import brickless.simulation.Library;
import brickless.simulation.SimulationSettings;
import brickless.simulation.StimuliReader;
import brickless.world.DescriptionException;
import brickless.world.World;
import java.io.File;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.TypeConversionException;

/** What the commands that run a program have in common. */
final class RunOptions {
    private static final Duration USUAL_LIMIT = Duration.ofSeconds(60);
    private static final Duration UNLIMITED = Duration.ofNanos(Long.MAX_VALUE);

    @Parameters(index = "0", paramLabel = "PROGRAM",
            description = "Class name, .java or .class file, directory of sources or classes, or jar.")
    String program;

    @Option(names = "--main", paramLabel = "CLASS", description = "Main class, if there are several.")
    String main;

    @Option(names = {"--classpath", "-cp"}, paramLabel = "PATH",
            description = "Further directories and jars the program needs.")
    String classPath = "";

    @Option(names = "--world", paramLabel = "WORLD", defaultValue = "pen",
            description = "World: SVG file or bundled name (default: pen).")
    String world;

    @Option(names = "--robot", paramLabel = "ROBOT", defaultValue = "auto",
            description = "Robot: SVG file, bundled name, or auto = fitted to the program (default).")
    String robot;

    @Option(names = "--for", paramLabel = "TIME", converter = PositiveDuration.class,
            description = "Simulated time limit: 500ms, 60s, 2m (default: 60s; view: none).")
    private Duration limit;

    @Option(names = "--seed", paramLabel = "N", defaultValue = "1",
            description = "Seed of noise and of the program's random numbers (default: 1).")
    long seed;

    @Option(names = "--schedule-seed", paramLabel = "N",
            description = "Runs the threads in a random order given by this seed.")
    Long scheduleSeed;

    @Option(names = "--stimuli", paramLabel = "FILE", description = "What people and the world do to the robot.")
    Path stimuli;

    @Option(names = "--buttons", paramLabel = "POLICY", converter = ButtonsConverter.class,
            description = "auto: keys the program waits for are pressed; none: never (default: auto; view: none).")
    private Buttons buttons;

    @Option(names = "--attended",
            description = "Somebody watches the brick: an exception waits on its screen for a key (always so in view).")
    private boolean attended;

    @Option(names = "--until", paramLabel = "GOAL", converter = GoalConverter.class,
            description = "zone:NAME or exit: the run succeeds only if this is reached.")
    Goal goal;

    @Option(names = "--ideal", description = "No noise, no latency, no slip.")
    boolean ideal;

    @Option(names = "--backend", paramLabel = "BACKEND", defaultValue = "auto", converter = BackendConverter.class,
            description = "auto, threads or continuation: how program threads are carried (default: auto).")
    BackendChoice backend;

    private boolean live;

    /** Somebody is there: no time limit and no automatic keys unless asked for, and exceptions wait for a key. */
    void forPeople() {
        live = true;
    }

    private Duration limit() {
        return limit != null ? limit : live ? UNLIMITED : USUAL_LIMIT;
    }

    private boolean pressButtons() {
        return buttons != null ? buttons == Buttons.AUTO : !live;
    }

    Program findProgram() {
        try {
            return finder(classPath, main).find(program);
        } catch (ProgramException e) {
            throw new UsageException(e.getMessage());
        }
    }

    static ProgramFinder finder(String classPath, String main) {
        List<Path> entries = classPath.isEmpty()
                ? List.of() : Arrays.stream(classPath.split(File.pathSeparator)).map(Path::of).toList();
        return new ProgramFinder(Path.of("").toAbsolutePath(), entries, Optional.ofNullable(main));
    }

    SimulationSettings settings() {
        return settings(world);
    }

    /** The settings for another world. */
    SimulationSettings settings(String worldName) {
        Library library = new Library(Path.of(""));
        try {
            World arena = library.world(worldName);
            SimulationSettings.Builder settings = SimulationSettings.builder(arena).worldFile(worldName).seed(seed)
                    .limit(limit()).ideal(ideal)
                    .pressButtons(pressButtons()).attended(attended || live).backend(backend)
                    .goal(Optional.ofNullable(goal))
                    .scheduleSeed(scheduleSeed == null ? OptionalLong.empty() : OptionalLong.of(scheduleSeed));
            if (!robot.equals("auto")) {
                settings.robot(library.robot(robot));
            }
            if (stimuli != null) {
                settings.stimuli(StimuliReader.read(stimuli));
            }
            return settings.build();
        } catch (DescriptionException e) {
            throw new UsageException(e.getMessage());
        }
    }

    /** The command that runs the same again, without a schedule seed. */
    String commandLine() {
        return commandLine(limit(), seed, stimuli);
    }

    /** The command that runs the same with another seed, stimuli from another file, and another limit. */
    String commandLine(Duration until, long otherSeed, Path stimuliFile) {
        StringBuilder words = new StringBuilder("brickless run ").append(quoted(program));
        append(words, "--main", main);
        append(words, "--classpath", classPath.isEmpty() ? null : classPath);
        append(words, "--world", world.equals("pen") ? null : world);
        append(words, "--robot", robot.equals("auto") ? null : robot);
        append(words, "--for", until.equals(USUAL_LIMIT) ? null : Durations.text(until));
        append(words, "--seed", otherSeed == 1 ? null : String.valueOf(otherSeed));
        append(words, "--stimuli", stimuliFile == null ? null : stimuliFile.toString());
        append(words, "--buttons", pressButtons() ? null : "none");
        append(words, "--until", goal == null ? null : goal.text());
        return words.append(attended || live ? " --attended" : "").append(ideal ? " --ideal" : "").toString();
    }

    private static void append(StringBuilder words, String option, String value) {
        if (value != null) {
            words.append(' ').append(option).append(' ').append(quoted(value));
        }
    }

    private static String quoted(String word) {
        return word.contains(" ") ? "'" + word + "'" : word;
    }

    private static final class PositiveDuration implements ITypeConverter<Duration> {
        @Override
        public Duration convert(String value) {
            return Durations.parse(value).filter(duration -> !duration.isZero())
                    .orElseThrow(() -> new TypeConversionException("'" + value
                            + "' is no time above zero; allowed: 500ms, 60s, 2m"));
        }
    }

    private static final class GoalConverter implements ITypeConverter<Goal> {
        @Override
        public Goal convert(String value) {
            return Goal.parse(value).orElseThrow(() ->
                    new TypeConversionException("'" + value + "' is no goal; allowed: zone:NAME, exit"));
        }
    }

    /** Who presses the keys that a program waits for. */
    enum Buttons { AUTO, NONE }

    private static final class ButtonsConverter implements ITypeConverter<Buttons> {
        @Override
        public Buttons convert(String value) {
            return switch (value) {
                case "auto" -> Buttons.AUTO;
                case "none" -> Buttons.NONE;
                default -> throw new TypeConversionException("'" + value
                        + "' is no button policy; allowed: auto, none");
            };
        }
    }

    private static final class BackendConverter implements ITypeConverter<BackendChoice> {
        @Override
        public BackendChoice convert(String value) {
            return switch (value) {
                case "auto" -> BackendChoice.AUTO;
                case "threads" -> BackendChoice.THREADS;
                case "continuation" -> BackendChoice.CONTINUATIONS;
                default -> throw new TypeConversionException("'" + value
                        + "' is no back-end; allowed: auto, threads, continuation");
            };
        }
    }
}
