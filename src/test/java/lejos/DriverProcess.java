package lejos;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Plays a driver in a JVM of its own, against the classes of that JVM's class path.
 *
 * <p>Published pilots and navigators start threads that never end, some of which never pause. In a JVM of their own
 * they end with it.
 */
public final class DriverProcess {
    private final Process process;
    private final Path sightings;
    private final Path console;

    /**
     * Starts a JVM that plays the indices from {@code begin} to {@code end} − 1.
     *
     * @param folder where to leave what it sees
     */
    DriverProcess(String classPath, Class<?> driver, int begin, int end, Path folder) {
        try {
            sightings = Files.createTempFile(folder, "sightings", ".txt");
            console = Files.createTempFile(folder, "console", ".txt");
            process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-cp", classPath, DriverProcess.class.getName(),
                    driver.getName(), String.valueOf(begin), String.valueOf(end), sightings.toString())
                    .redirectErrorStream(true).redirectOutput(console.toFile()).start();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** What the driver saw, a map for each index, once all have been played. */
    List<Map<String, Double>> sightings() {
        try {
            if (process.waitFor() != 0) {
                throw new AssertionError("a driver failed:\n" + Files.readString(console));
            }
            List<Map<String, Double>> maps = new ArrayList<>();
            for (String line : Files.readAllLines(sightings)) {
                int tab = line.lastIndexOf('\t');
                if (tab < 0) {
                    maps.add(new LinkedHashMap<>());
                } else {
                    maps.get(maps.size() - 1).put(line.substring(0, tab), Double.valueOf(line.substring(tab + 1)));
                }
            }
            return maps;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            process.destroyForcibly();
            throw new AssertionError("interrupted", e);
        }
    }

    /**
     * Plays in this JVM.
     *
     * @param args class of the driver, first index, index behind the last one, file for what it sees
     */
    @SuppressWarnings("unchecked")
    public static void main(String[] args) throws Exception {
        Method play = Class.forName(args[0]).getDeclaredMethod("play", int.class);
        play.setAccessible(true);
        try (PrintWriter out = new PrintWriter(Files.newBufferedWriter(Path.of(args[3]), StandardCharsets.UTF_8))) {
            for (int index = Integer.parseInt(args[1]); index < Integer.parseInt(args[2]); index++) {
                out.println(index);
                ((Map<String, Double>) play.invoke(null, index))
                        .forEach((label, value) -> out.println(label + "\t" + value));
            }
        } catch (ReflectiveOperationException e) {
            e.printStackTrace();
            Runtime.getRuntime().halt(1);
        }
        Runtime.getRuntime().halt(0); // whatever threads the driver has left behind
    }
}
