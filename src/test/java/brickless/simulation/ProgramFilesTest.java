package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFinder;
import brickless.world.DescriptionException;
import brickless.world.World;
import brickless.world.svg.SvgWorldReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import programs.files.AppendingLogger;
import programs.files.FolderTour;
import programs.files.FullCard;
import programs.files.Gifts;
import programs.files.OddNames;
import programs.files.OtherPrograms;
import programs.files.PathsTour;
import programs.files.Picture;
import programs.files.RandomAccess;
import programs.files.StreamsTour;

/** Each robot of each run has files of its own; nothing of the host shows, and nothing there changes. */
class ProgramFilesTest {
    private static final Library LIBRARY = new Library(Path.of("no-files-here"));
    private static final List<Path> NAMES_OF_THE_PROGRAMS =
            Stream.of("drive.log", "a.txt", "data.bin", "log.txt", "table.bin", "host.txt", "new.txt",
            "small", "Case").map(Path::of).toList();

    private static final String REFUSED = "this class of the JDK opens files by itself, which it cannot on a simulated "
            + "brick; give it a stream, or use another class";

    @TempDir Path folder;
    @TempDir Path gifts;

    private SimulationSettings.Builder settings() throws DescriptionException {
        return settings(LIBRARY.world("pen"));
    }

    private SimulationSettings.Builder settings(World world) throws DescriptionException {
        return SimulationSettings.builder(world).robot(LIBRARY.robot("educator")).limit(Duration.ofSeconds(20))
                .out(Optional.of(folder.resolve("run")));
    }

    private static Run run(Class<?> program, SimulationSettings settings) {
        return run(Program.onClassPath(program.getName()), settings);
    }

    private static Run run(Program program, SimulationSettings settings) {
        Run run = new Simulation(settings).start(program);
        run.toEnd();
        assertThat(run.outcome().exitStatus()).as(run.outcome() + " " + run.robot().printedLines()).contains(0);
        return run;
    }

    private List<String> printedBy(Class<?> program) throws DescriptionException {
        return run(program, settings().build()).robot().printedLines();
    }

    private List<String> inFolder(String name) throws IOException {
        Path root = folder.resolve("run").resolve(name);
        if (!Files.exists(root)) {
            return List.of();
        }
        try (Stream<Path> files = Files.walk(root)) {
            return files.filter(Files::isRegularFile).map(file -> root.relativize(file).toString()).sorted().toList();
        }
    }

    @AfterEach
    void nothingWasWrittenWhereTheTestsRun() {
        assertThat(NAMES_OF_THE_PROGRAMS).noneMatch(Files::exists);
    }

    @Test
    void streamsReadersAndWritersFindWhatWasWritten() throws DescriptionException {
        assertThat(printedBy(StreamsTour.class)).containsExactly("available 22", "1234567 2.5 été", "rest 789-1",
                "skipped 12, then 0, left 9",
                "bytes 11 1", "1.3 ä|3.5|null", "1.3 ä 3.5", "ä", "printed, 4 of five", "[3, 1, 4] pi",
                "nothing.txt (No such file or directory)", "/home/lejos/programs (Is a directory)",
                "/etc/passwd (No such file or directory)",
                "no/such/folder.txt (No such file or directory)", "/data.bin/x (No such file or directory)",
                "Stream Closed",
                "to the console", "1;2.5;x");
    }

    @Test
    void foldersAreListedInOrderAndDatesAreTheProgramsOwn() throws DescriptionException {
        assertThat(printedBy(FolderTour.class)).containsExactly("sub/../log.txt log.txt sub/.. false",
                "/home/lejos/programs/sub/../log.txt /home/lejos/programs/log.txt", "false true",
                "file:/home/lejos/programs/a true",
                "false true", "/home/lejos/programs /home/root",
                "false true false true", "100 truetruefalse", "Thu Jan 01 00:00:00 UTC 2015 true", "true 5000",
                "true false 100",
                "67108864 100", "/tmp/tmp1.dat true",
                "false true false", "[10, 9, Apple, mango, zebra]", "[deep/er]", "[10, 9]", "[deep/er] null",
                "[lejos, root] [/]",
                "false true false", "true true false", "No such file or directory");
    }

    @Test
    void pathsLeadToTheSameFiles() throws DescriptionException {
        assertThat(printedBy(PathsTour.class)).containsExactly("[one, zwölf, three] 17", "[written] written",
                "onezwölf",
                "/home/lejos/programs/log.txt true true", "a a/b a/b/c a/b/c/y.csv a/b/c/z.txt a/b/x.txt",
                "[z.txt] truefalsefalse",
                "2015-01-01T00:00:00.003Z true", "there: copy.txt", "false 17", "true false", "none: w.txt", "5 0",
                "[2, 3] 3 of 4",
                "files of a simulated brick cannot be mapped into memory", "/tmp/t1.x /tmp/d2", "true",
                "false false", "true");
    }

    @Test
    void randomAccessFilesAreReadAndWrittenAnywhere() throws DescriptionException {
        assertThat(printedBy(RandomAccess.class)).containsExactly("9 1.5 at 48 of 60", "-1 44 line next ü xy -1",
                "6 0", "end of file",
                "IOException", "absent (No such file or directory)");
    }

    @Test
    void aFullCardIsAnError() throws DescriptionException {
        assertThat(printedBy(FullCard.class)).containsExactly("64 No space left on device 0", "true 64");
    }

    @Test
    void otherProgramsAndFilesOfTheHostAreOutOfReach() throws DescriptionException {
        assertThat(printedBy(OtherPrograms.class))
                .containsExactly("Cannot run program \"touch\": error=2, No such file or directory",
                "Cannot run program \"touch\": error=2, No such file or directory",
                REFUSED, REFUSED, REFUSED, REFUSED);
    }

    @Test
    void picturesAreFilesOfTheBrick() throws DescriptionException {
        Run run = run(Picture.class, settings().build());
        assertThat(run.robot().printedLines()).containsExactly("true 3 by 2, red ff0000");
        assertThat(run.robot().filesWritten()).containsExactly("picture.png");
    }

    @Test
    void everyRunHasAFreshBrick() throws DescriptionException {
        Run first = run(AppendingLogger.class, settings().build());
        Run second = run(AppendingLogger.class, settings().build());
        assertThat(first.robot().printedLines()).containsExactly("lines 1");
        assertThat(second.robot().printedLines()).containsExactly("lines 1");
        assertThat(second.report().traceHash()).isEqualTo(first.report().traceHash());
        assertThat(second.robot().fileText("drive.log")).isEqualTo(first.robot().fileText("drive.log"));
    }

    @Test
    void allRunsOfASimulationHaveFreshBricks() throws DescriptionException {
        Simulation simulation = new Simulation(settings().build());
        for (int i = 0; i < 3; i++) {
            Run run = simulation.start(AppendingLogger.class);
            run.toEnd();
            assertThat(run.robot().printedLines()).containsExactly("lines 1");
        }
    }

    @Test
    void whatWasWrittenIsInTheFolderOfTheRun() throws DescriptionException, IOException {
        Run run = run(AppendingLogger.class, settings().build());
        assertThat(inFolder("files")).containsExactly("drive.log");
        assertThat(folder.resolve("run/files/drive.log")).hasContent(run.robot().fileText("drive.log"));
        assertThat(run.robot().fileText("drive.log")).matches("1420070400\\d{3} \\d+\n");
        assertThat(run.robot().filesWritten()).containsExactly("drive.log");
        assertThat(run.report().notes()).contains("files written: drive.log (" + run.robot().fileBytes("drive.log")
                .length + " bytes)");
        assertThat(folder.resolve("run/files.tsv")).hasContent("robot\tfile on the brick\tbytes\tfile here\n"
                + "robot\t/home/lejos/programs/drive.log\t" + run.robot().fileBytes("drive.log").length
                + "\tfiles/drive.log\n");
    }

    @Test
    void aFileIsSeenWhileTheRunIsHeld() throws DescriptionException {
        try (Run run = new Simulation(settings().build()).start(AppendingLogger.class)) {
            assertThat(run.robot().filesWritten()).isEmpty();
            assertThatThrownBy(() -> run.robot().fileText("drive.log")).isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("no file drive.log on the brick of robot; written so far: none");
            run.advanceUntil(r -> !r.robot().filesWritten().isEmpty(), Duration.ofSeconds(5));
            assertThat(run.ended()).isFalse();
            assertThat(run.robot().filesWritten()).containsExactly("drive.log");
        }
    }

    @Test
    void filesOfAnEarlierRunGoWithItsOtherFiles() throws DescriptionException, IOException {
        run(FolderTour.class, settings().build());
        assertThat(inFolder("files")).containsExactly("brick/home/root/other.txt", "brick/tmp/tmp2.tmp");
        Path own = Files.writeString(folder.resolve("run/files/notes-of-the-user.txt"), "keep");
        run(AppendingLogger.class, settings().build());
        assertThat(inFolder("files")).containsExactly("drive.log", "notes-of-the-user.txt");
        Files.delete(own);
        run(FullCard.class, settings().build());
        assertThat(inFolder("files")).containsExactly("small");
        run(OtherPrograms.class, settings().build());
        assertThat(folder.resolve("run/files")).doesNotExist();
        assertThat(folder.resolve("run/files.tsv")).doesNotExist();
    }

    @Test
    void oddNamesBecomeNamesThatEveryHostCanHave() throws DescriptionException, IOException {
        Run run = run(OddNames.class, settings().build());
        assertThat(run.robot().filesWritten()).hasSize(9).contains("C:\\log?.txt", "größe.txt", "/tmp/x", "tab\there");
        assertThat(inFolder("files")).hasSize(9).contains("brick/tmp/x", "C__log_.txt", "C__log_.txt~2", "tab_here")
                .allMatch(name -> name.getBytes(StandardCharsets.UTF_8).length < 250);
        assertThat(run.report().notes().toString()).contains("/tmp/x (1 bytes)");
    }

    @Test
    void twoRobotsWriteFilesOfTheSameName() throws DescriptionException, IOException {
        World world = SvgWorldReader.readText("two.svg",
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2000 2000'>"
                + "<g data-robot='left' transform='translate(500 500)'/>"
                + "<g data-robot='right' transform='translate(500 1500)'/></svg>");
        Run run = run(AppendingLogger.class, settings(world).build());
        assertThat(run.robots()).hasSize(2).allSatisfy(robot -> {
            assertThat(robot.printedLines()).containsExactly("lines 1");
            assertThat(robot.filesWritten()).containsExactly("drive.log");
        });
        assertThat(inFolder("files")).containsExactly("drive.log");
        assertThat(inFolder("files-right")).containsExactly("drive.log");
    }

    @Test
    void filesOfTheUserLieOnTheBrickAndAreNotChanged() throws DescriptionException, IOException {
        Files.writeString(gifts.resolve("greeting.txt"), "hello\n");
        Files.writeString(gifts.resolve("unwanted.txt"), "x");
        Files.createDirectories(gifts.resolve("maps"));
        Files.writeString(gifts.resolve("maps/room.svg"), "<svg/>");
        Run run = run(Gifts.class, settings().files(Optional.of(gifts)).build());
        assertThat(run.robot().printedLines()).containsExactly("[greeting.txt, maps, unwanted.txt]", "hello",
                "[hello, and again]",
                "6 1420070400000", "true false", "sound -9");
        assertThat(inFolder("files")).as("only what is new").containsExactly("greeting.txt");
        assertThat(gifts.resolve("greeting.txt")).hasContent("hello\n");
        assertThat(gifts.resolve("unwanted.txt")).exists();
        assertThat(run.robot().fileText("maps/room.svg")).isEqualTo("<svg/>");
    }

    @Test
    void aLogOfTheUserGoesOn() throws DescriptionException, IOException {
        Files.writeString(gifts.resolve("drive.log"), "1\n2\n");
        Run run = run(AppendingLogger.class, settings().files(Optional.of(gifts)).build());
        assertThat(run.robot().printedLines()).containsExactly("lines 3");
        assertThat(gifts.resolve("drive.log")).hasContent("1\n2\n");
    }

    @Test
    void filesBesideTheProgramAreThere() throws DescriptionException, IOException, ProgramException {
        Path programs = Files.createDirectories(folder.resolve("programs"));
        Files.writeString(programs.resolve("Reader.java"), """
                public class Reader {
                    public static void main(String[] args) throws java.io.IOException {
                        System.out.println(String.join(" ", new java.io.File(".").list()));
                        System.out.println(new java.util.Scanner(new java.io.File("speed.txt")).nextInt());
                    }
                }
                """);
        Files.writeString(programs.resolve("speed.txt"), "250");
        Files.writeString(programs.resolve("song.wav"), "beep");
        Files.writeString(programs.resolve(".hidden"), "x");
        Files.writeString(Files.createDirectories(programs.resolve("sub")).resolve("deep.txt"), "x");
        Files.writeString(gifts.resolve("speed.txt"), "300");
        for (String name : List.of("Reader.java", ".")) {
            try (Program program = new ProgramFinder(programs, List.of(), Optional.empty())
                    .find(programs.resolve(name).toString())) {
                assertThat(run(program, settings().build()).robot().printedLines()).as(name)
                        .containsExactly("song.wav speed.txt", "250");
                assertThat(run(program, settings().files(Optional.of(gifts)).build()).robot().printedLines())
                        .as(name + " and --files")
                        .containsExactly("song.wav speed.txt", "300");
            }
        }
    }

    @Test
    void aFolderForTheBrickMustBeOneAndNotThatOfTheRun() throws DescriptionException, IOException {
        Path absent = gifts.resolve("absent");
        assertThatThrownBy(() -> new Simulation(settings().files(Optional.of(absent)).build()).start(Gifts.class))
                .isInstanceOf(SetupException.class).hasMessage(absent
                + ": no such folder; what it holds would be put on the brick");
        Path file = Files.writeString(gifts.resolve("file"), "x");
        assertThatThrownBy(() -> new Simulation(settings().files(Optional.of(file)).build()).start(Gifts.class))
                .isInstanceOf(SetupException.class).hasMessageStartingWith(file + ": is no folder");
        Path own = Files.createDirectories(folder.resolve("run/files"));
        assertThatThrownBy(() -> new Simulation(settings().files(Optional.of(own)).build()).start(Gifts.class))
                .isInstanceOf(SetupException.class).hasMessageStartingWith(own
                + ": lies in the folder that this run writes");
    }

    @Test
    void resultsOfEarlierRunsAreNotPutOnTheBrick() throws DescriptionException, IOException {
        Files.writeString(folder.resolve("greeting.txt"), "hello");
        SimulationSettings settings = settings().files(Optional.of(folder)).build();
        List<String> hashes = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            Run run = run(Gifts.class, settings);
            assertThat(run.robot().printedLines().get(0)).isEqualTo("[greeting.txt]");
            hashes.add(run.report().traceHash());
        }
        assertThat(hashes.get(1)).isEqualTo(hashes.get(0));
    }
}
