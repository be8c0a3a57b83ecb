package brickless.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The JDKs of this machine on which Brickless runs: 17 and later. */
public final class InstalledJdks {
    private static final int OLDEST = 17;
    private static final Pattern VERSION = Pattern.compile("JAVA_VERSION=\"(\\d+)");

    private InstalledJdks() {}

    /** Homes of the JDKs: the running one first, then others in the usual places, of each version one. */
    public static List<Path> homes() throws IOException {
        List<Path> candidates = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"))));
        Path installed = Path.of("/usr/lib/jvm");
        if (Files.isDirectory(installed)) {
            try (Stream<Path> found = Files.list(installed)) {
                found.filter(home -> !Files.isSymbolicLink(home)).sorted().forEach(candidates::add);
            }
        }
        System.getenv().entrySet().stream()
                .filter(entry -> entry.getKey().matches("(JDK_?HOME|JAVA_?HOME)_?\\w*|BRICKLESS_JAVA_HOME"))
                .sorted(Map.Entry.comparingByKey()).forEach(entry -> candidates.add(Path.of(entry.getValue())));
        List<Path> homes = new ArrayList<>();
        List<Integer> versions = new ArrayList<>();
        for (Path home : candidates) {
            int version = version(home);
            if (version >= OLDEST && !versions.contains(version) && Files.isExecutable(home.resolve("bin/java"))) {
                homes.add(home);
                versions.add(version);
            }
        }
        return homes;
    }

    /** Feature version of a JDK, 0 if it does not say. */
    public static int version(Path home) throws IOException {
        Path release = home.resolve("release");
        Matcher version = VERSION.matcher(Files.exists(release) ? Files.readString(release) : "");
        return version.find() ? Integer.parseInt(version.group(1)) : 0;
    }
}
