package brickless.simulation;

import brickless.files.BrickFiles;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The files that programs wrote, in the folder of the run: {@code files/} for the first robot, {@code files-NAME/} for
 * others. What lies
 * outside of the folder where programs start is below {@code brick/} there. {@code files.tsv} lists them, so that the
 * next run into the same
 * folder can take them away.
 */
final class WrittenFiles {
    private static final String LIST = "files.tsv";
    private static final String HOME = BrickFiles.WORKING_FOLDER + "/";
    private static final int MOST_NAMES = 10;
    private static final int LONGEST_NAME = 200;

    private final RunFolder folder;
    private final List<String> lines = new ArrayList<>();
    private final Set<String> taken = new HashSet<>();

    WrittenFiles(RunFolder folder) {
        this.folder = folder;
    }

    /** Names as the program would write them. */
    static List<String> names(BrickFiles files) {
        return files.written().keySet().stream().map(WrittenFiles::shortName).toList();
    }

    /** One line for the summary; empty if the program wrote none. */
    static Optional<String> describe(BrickFiles files) {
        Map<String, Integer> written = files.written();
        if (written.isEmpty()) {
            return Optional.empty();
        }
        List<String> words = written.entrySet().stream().limit(MOST_NAMES)
                .map(file -> String.format(Locale.ROOT, "%s (%,d bytes)", shortName(file.getKey()), file.getValue()))
                .toList();
        int more = written.size() - words.size();
        return Optional.of("files written: " + String.join(", ", words) + (more > 0 ? " and " + more + " more" : ""));
    }

    private static String shortName(String path) {
        return path.startsWith(HOME) ? path.substring(HOME.length()) : path;
    }

    /** Writes those of a robot. */
    void write(String subfolder, RobotSession robot) {
        if (robot.files().isEmpty()) {
            return;
        }
        BrickFiles files = robot.files().get();
        files.written().forEach((path, bytes) -> {
            String name = free(subfolder + "/" + hostName(path));
            folder.write(name, content(files, path));
            lines.add(robot.name() + "\t" + path + "\t" + bytes + "\t" + name);
        });
    }

    private static byte[] content(BrickFiles files, String path) {
        try {
            return files.read(path);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A name that any host can have: odd signs are replaced, and long words cut. */
    private static String hostName(String path) {
        String name = path.startsWith(HOME) ? path.substring(HOME.length()) : "brick" + path;
        return Arrays.stream(name.split("/")).map(WrittenFiles::hostWord).collect(Collectors.joining("/"));
    }

    private static String hostWord(String word) {
        String plain = word.replaceAll("[\\\\:*?\"<>|\\p{Cntrl}]", "_");
        boolean fits = plain.getBytes(StandardCharsets.UTF_8).length <= LONGEST_NAME && isPossible(plain);
        String ascii = fits ? plain : plain.replaceAll("[^ -~]", "_");
        return ascii.substring(0, Math.min(ascii.length(), LONGEST_NAME));
    }

    /** Some hosts are set up for few letters. */
    private static boolean isPossible(String name) {
        try {
            return !Path.of(name).toString().isEmpty();
        } catch (InvalidPathException unknownLetters) {
            return false;
        }
    }

    /** Hosts may take names for the same that the brick distinguishes. */
    private String free(String name) {
        String free = name;
        for (int i = 2; !taken.add(free.toLowerCase(Locale.ROOT)); i++) {
            free = name + "~" + i;
        }
        return free;
    }

    /** Takes away what an earlier run left, and lists what this one wrote. */
    void finish() {
        try {
            removeOld(folder.path().resolve(LIST));
        } catch (IOException e) {
            throw new UncheckedIOException("the files that the program wrote in an earlier run cannot be removed", e);
        }
        if (!lines.isEmpty()) {
            folder.write(LIST, "robot\tfile on the brick\tbytes\tfile here\n" + String.join("\n", lines) + "\n");
        }
    }

    private void removeOld(Path list) throws IOException {
        if (!Files.isRegularFile(list)) {
            return;
        }
        for (String line : Files.readAllLines(list, StandardCharsets.UTF_8)) {
            String name = line.substring(line.lastIndexOf('\t') + 1);
            Path file = folder.path().resolve(name).normalize();
            if (name.startsWith("files") && name.contains("/") && file.startsWith(folder.path().normalize())) {
                Files.deleteIfExists(file);
                removeEmpty(file.getParent());
            }
        }
        Files.delete(list);
    }

    private void removeEmpty(Path emptied) throws IOException {
        try {
            for (Path each = emptied; !each.equals(folder.path().normalize()); each = each.getParent()) {
                Files.deleteIfExists(each);
            }
        } catch (DirectoryNotEmptyException inUse) {
            assert inUse != null : "the next file is still there, or a new one";
        }
    }
}
