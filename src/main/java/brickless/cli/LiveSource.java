package brickless.cli;

import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFiles;
import brickless.simulation.SetupException;
import brickless.simulation.SimulationSettings;
import brickless.viewer.RunSource;
import brickless.world.Placement;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/** What the options of a command say, ready to be watched. */
final class LiveSource implements RunSource {
    private static final Path SAVED = Path.of("stimuli.txt");

    private final RunOptions options;
    private final Optional<Path> out;
    private final OutputStream console;

    LiveSource(RunOptions options, Optional<Path> out, OutputStream console) {
        this.options = options;
        this.out = out;
        this.console = console;
    }

    @Override
    public Prepared prepare(OptionalLong seed) {
        try {
            Program program = options.findProgram();
            boolean ready = false;
            try {
                Prepared prepared = prepared(program, seed.orElse(options.seed));
                ready = true;
                return prepared;
            } finally {
                if (!ready) {
                    program.close();
                }
            }
        } catch (UsageException | ProgramException e) {
            throw new SetupException(e.getMessage());
        }
    }

    private Prepared prepared(Program program, long seed) throws ProgramException {
        Path folder = out.orElse(Path.of("build", "simulations", program.simpleName()));
        SimulationSettings settings = options.settings().toBuilder().seed(seed).console(console)
                .out(Optional.of(folder)).build();
        return new Prepared(program, settings, files(program, settings),
                limit -> options.commandLine(limit, seed, SAVED));
    }

    /** Files that somebody may edit while the run is watched. */
    private List<Path> files(Program program, SimulationSettings settings) throws ProgramException {
        List<Path> files = new ArrayList<>(ProgramFiles.of(Path.of("").toAbsolutePath(), program));
        files.add(Path.of(options.world));
        files.add(Path.of(options.robot));
        Optional.ofNullable(options.stimuli).ifPresent(files::add);
        Path beside = Optional.ofNullable(Path.of(options.world).getParent()).orElse(Path.of(""));
        for (Placement placement : settings.world().placements()) {
            placement.model().map(beside::resolve).ifPresent(files::add);
            placement.program().map(beside::resolve).ifPresent(files::add);
        }
        return files.stream().filter(Files::isRegularFile).map(file -> file.toAbsolutePath().normalize())
                .distinct().toList();
    }
}
