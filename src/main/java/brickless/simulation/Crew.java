package brickless.simulation;

import brickless.loading.hints.HardwareHints;
import brickless.loading.hints.HintFinder;
import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFiles;
import brickless.program.ProgramFinder;
import brickless.world.DescriptionException;
import brickless.world.Placement;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.World;
import brickless.world.svg.WorldCheck;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Who takes part in a run: every robot of the world with its model, start pose and program. Programs that the world
 * names are found, and
 * compiled where needed, for this run; {@link #close} removes what was compiled.
 */
final class Crew implements AutoCloseable {
    /**
     * One robot.
     *
     * @param name name in the world
     * @param model what it is built of
     * @param start where it starts
     * @param program what it runs
     * @param fitted whether the model was fitted to the program
     * @param folder where the program lies
     */
    record Member(String name, RobotModel model, Pose2 start, Program program, boolean fitted, Optional<Path> folder) {}

    private final SimulationSettings settings;
    private final Program program;
    private final List<Program> found = new ArrayList<>();

    Crew(SimulationSettings settings, Program program) {
        this.settings = settings;
        this.program = program;
    }

    /** All robots; a world that places none gets one in its middle. */
    List<Member> members() {
        Upload.check(settings);
        World world = settings.world();
        List<Member> members = new ArrayList<>();
        if (world.placements().isEmpty()) {
            Pose2 middle = new Pose2(world.minX() + world.width() / 2, world.minY() + world.height() / 2, 0);
            members.add(member(new Placement("robot", middle, Optional.empty(), Optional.empty())));
        }
        for (Placement placement : world.placements()) {
            members.add(member(placement));
        }
        return members;
    }

    private Member member(Placement placement) {
        try {
            Path directory = placement.program().isPresent() ? worldFolder() : Path.of("").toAbsolutePath();
            Program own = placement.program().isPresent() ? find(directory, placement.program().get()) : program;
            boolean fitted = settings.robot().isEmpty() && placement.model().isEmpty();
            RobotModel model = fitted ? RobotFitter.fit(hints(own)) : drawn(placement);
            String file = settings.worldFile().isEmpty() ? settings.world().name() + ".svg" : settings.worldFile();
            WorldCheck.placement(file, settings.world(), model, placement.start());
            return new Member(placement.name(), model, placement.start(), own, fitted,
                    ProgramFiles.folder(directory, own));
        } catch (DescriptionException | ProgramException e) {
            throw new SetupException(e.getMessage());
        }
    }

    private RobotModel drawn(Placement placement) throws DescriptionException {
        return placement.model().isPresent() ? new Library(Path.of(""))
                .modelOf(settings.worldFile(), placement.model().get())
                : settings.robot().orElseThrow();
    }

    /** Programs that the world names lie beside it. */
    private Path worldFolder() {
        return Optional.ofNullable(Path.of(settings.worldFile()).toAbsolutePath().getParent())
                .orElse(Path.of("").toAbsolutePath());
    }

    private Program find(Path folder, String name) throws ProgramException {
        Program named = new ProgramFinder(folder, List.of(), Optional.empty()).find(name);
        found.add(named);
        return named;
    }

    @Override
    public void close() {
        found.forEach(Program::close);
        found.clear();
    }

    private static HardwareHints hints(Program program) {
        return HintFinder.find(new ProgramClasses(program).ofMain());
    }
}
