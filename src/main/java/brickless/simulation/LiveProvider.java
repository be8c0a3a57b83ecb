package brickless.simulation;

import brickless.hardware.BrickHardware;
import brickless.hardware.BrickProvider;
import brickless.program.Program;
import brickless.world.DescriptionException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Starts a live simulation for a program that was started as plain Java: {@code java -cp brickless.jar:classes
 * MyProgram}, or in an IDE.
 *
 * <p>System properties, none of them needed: {@code brickless.world} and {@code brickless.robot} (SVG file or bundled
 * name; by default the pen, and a robot fitted to the program), {@code brickless.seed}, {@code brickless.out} (folder
 * for the files of the run).
 */
public final class LiveProvider implements BrickProvider {
    private static final String AUTO = "auto";

    /** For the service loader. */
    public LiveProvider() {}

    /**
     * Starts the simulation; its time follows the wall clock from now on.
     *
     * @throws SetupException if a property names something that is not there
     */
    @Override
    public BrickHardware startLive() {
        Program program = RunningProgram.mainClass().map(Program::onClassPath).orElseGet(Program::unknown);
        try {
            return new LiveRun(settings(), program).start();
        } catch (DescriptionException e) {
            throw new SetupException(e.getMessage());
        }
    }

    private static SimulationSettings settings() throws DescriptionException {
        Library library = new Library(Path.of(""));
        String world = System.getProperty("brickless.world", "pen");
        String robot = System.getProperty("brickless.robot", AUTO);
        SimulationSettings.Builder settings = SimulationSettings.builder(library.world(world))
                .worldFile(world).seed(seed())
                .out(Optional.ofNullable(System.getProperty("brickless.out")).map(Path::of));
        if (!robot.equals(AUTO)) {
            settings.robot(library.robot(robot));
        }
        return settings.build();
    }

    private static long seed() {
        String seed = System.getProperty("brickless.seed", "1");
        try {
            return Long.parseLong(seed);
        } catch (NumberFormatException e) {
            throw new SetupException("brickless.seed: '" + seed + "' is no whole number");
        }
    }
}
