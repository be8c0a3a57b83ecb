package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.world.DescriptionException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import programs.files.FolderTour;
import programs.files.PathsTour;
import programs.files.RandomAccess;
import programs.files.StreamsTour;

class ProgramFilesTest {
    @TempDir Path folder;

    private Run run(Class<?> program) throws DescriptionException {
        Library library = new Library(Path.of("no-files-here"));
        Run run = new Simulation(SimulationSettings.builder(library.world("pen")).robot(library.robot("educator")).out(Optional.of(folder)).build()).start(program);
        run.toEnd();
        System.out.println("=== " + program.getSimpleName() + " " + run.outcome());
        run.robot().printedLines().forEach(System.out::println);
        System.out.println(run.report().text());
        return run;
    }

    @Test void show() throws Exception {
        for (Class<?> c : new Class<?>[] {StreamsTour.class, RandomAccess.class, FolderTour.class, PathsTour.class, programs.files.FullCard.class, programs.files.OtherPrograms.class, programs.files.AppendingLogger.class}) {
            run(c);
        }
    }
}
