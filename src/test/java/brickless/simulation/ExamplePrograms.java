package brickless.simulation;

import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFinder;
import brickless.world.DescriptionException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The programs of {@code sim/programs}, compiled once for a class of tests, and the traces of their runs. */
final class ExamplePrograms implements AutoCloseable {
    /** Main classes of most programs, of each kind at least one, in alphabetical order. */
    static final List<String> MAINS = List.of("bumper.BumperCar", "busywait.BusyWait", "detectors.RangeStop",
            "explorer.Explorer", "linefollower.LineFollower", "localize.Localize", "sensorthreads.SensorThreads",
            "square.Square", "thereandback.ThereAndBack", "wallstop.WallStop", "wanderer.Wanderer",
            "waypoints.Waypoints");

    private final Program compiled;

    private ExamplePrograms(Program compiled) {
        this.compiled = compiled;
    }

    static ExamplePrograms compiled() throws ProgramException {
        Path home = Path.of(System.getProperty("brickless.home"));
        return new ExamplePrograms(new ProgramFinder(home, List.of(), Optional.of(MAINS.get(0))).find("sim/programs"));
    }

    /** The program with this main class. */
    Program program(String main) {
        return new Program(main, main, compiled.classPath(), Optional.empty());
    }

    /** Settings for a bundled world with the educator robot. */
    static SimulationSettings.Builder settings(String world) throws DescriptionException {
        Library library = new Library(Path.of(System.getProperty("brickless.home"), "no-files-here"));
        return SimulationSettings.builder(library.world(world)).worldFile(world).robot(library.robot("educator"));
    }

    /** The world that shows what a program is for. */
    static String worldOf(String main) {
        return main.equals("linefollower.LineFollower") ? "line-loop" : "pen";
    }

    @Override
    public void close() {
        compiled.close();
    }

    /** A trace file. */
    record Trace(List<String> lines) {
        static Trace in(Path folder) {
            try {
                return new Trace(Files.readAllLines(folder.resolve("trace.jsonl")));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        /** Lines of a type. */
        List<String> of(String type) {
            return lines.stream().filter(line -> line.contains("\"type\":\"" + type + "\"")).toList();
        }

        /** A numeric field of each line of a type; of samples, the first robot's. */
        double[] numbers(String type, String field) {
            Pattern number = Pattern.compile("\"" + field + "\":(-?[\\d.]+)");
            return of(type).stream().map(number::matcher).filter(Matcher::find)
                    .mapToDouble(found -> Double.parseDouble(found.group(1))).toArray();
        }
    }
}
