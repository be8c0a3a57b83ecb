package brickless.simulation;

import brickless.world.DescriptionException;
import brickless.world.RobotModel;
import brickless.world.World;
import brickless.world.svg.SvgRobotReader;
import brickless.world.svg.SvgWorldReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Worlds and robots by file name, or by the name of one that comes with Brickless ({@code pen}, {@code educator} …).
 */
public final class Library {
    /** Names of the worlds that come with Brickless. */
    public static final List<String> WORLDS = List.of("pen", "line-loop", "line-crossings", "maze", "corridor",
            "obstacle-course", "colour-tiles", "table-top", "sumo-ring", "beacon-room", "can-field", "lamp-room");
    /** Names of the robots that come with Brickless. */
    public static final List<String> ROBOTS = List.of("educator", "tribot-caster", "medium-turret", "gripper",
            "tracked", "sumo", "three-wheel-holonomic");

    private final Path directory;

    /** Creates a library in which relative file names refer to {@code directory}. */
    public Library(Path directory) {
        this.directory = directory;
    }

    /** Reads a world from a file, or the bundled one of that name. */
    public World world(String name) throws DescriptionException {
        Path file = directory.resolve(name);
        if (Files.exists(file)) {
            return SvgWorldReader.read(file);
        }
        if (WORLDS.contains(name)) {
            return SvgWorldReader.readText(name + ".svg", bundled("worlds", name));
        }
        throw new DescriptionException(name, 0, "", "no such world: neither a file nor one of "
                + String.join(", ", WORLDS));
    }

    /** Reads a robot from a file, or the bundled one of that name. */
    public RobotModel robot(String name) throws DescriptionException {
        Path file = directory.resolve(name);
        if (Files.exists(file)) {
            return SvgRobotReader.read(file);
        }
        if (ROBOTS.contains(name)) {
            return SvgRobotReader.readText(name + ".svg", bundled("robots", name));
        }
        throw new DescriptionException(name, 0, "", "no such robot: neither a file nor one of "
                + String.join(", ", ROBOTS));
    }

    /**
     * Reads the robot that a world's drawing names in {@code data-model}, relative to the world's file; falls back to
     * the bundled robot of the same file name.
     */
    public RobotModel modelOf(String worldName, String model) throws DescriptionException {
        Optional<Path> folder = Optional.ofNullable(directory.resolve(worldName).getParent());
        Path file = folder.orElse(directory).resolve(model);
        if (Files.exists(file)) {
            return SvgRobotReader.read(file);
        }
        String simple = Path.of(model).getFileName().toString().replaceFirst("\\.svg$", "");
        if (ROBOTS.contains(simple)) {
            return SvgRobotReader.readText(simple + ".svg", bundled("robots", simple));
        }
        throw new DescriptionException(worldName, 0, "data-model=\"" + model + "\"", "no such robot file");
    }

    private static String bundled(String kind, String name) {
        String resource = "/brickless/" + kind + "/" + name + ".svg";
        try (InputStream in = Library.class.getResourceAsStream(resource)) {
            if (in == null) {
                throw new IllegalStateException(resource + " is missing from the brickless jar");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
