package programs.files;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Scanner;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Files with {@code java.nio.file}. */
public class PathsTour {
    public static void main(String[] args) throws IOException {
        lines();
        folders();
        copies();
        channels();
        others();
    }

    private static void lines() throws IOException {
        Path log = Paths.get("log.txt");
        Files.write(log, Arrays.asList("one", "zwölf"));
        Files.write(log, "three\n".getBytes(StandardCharsets.UTF_8), StandardOpenOption.APPEND);
        System.out.println(Files.readAllLines(log) + " " + Files.size(log));
        try (BufferedWriter writer = Files.newBufferedWriter(Path.of("sub").resolveSibling("w.txt"))) {
            writer.write("written");
        }
        try (Stream<String> lines = Files.lines(Path.of("w.txt"))) {
            System.out.println(lines.collect(Collectors.toList()) + " " + Files.readString(Path.of("w.txt")));
        }
        try (Scanner scanner = new Scanner(log)) {
            System.out.println(scanner.next() + scanner.next());
        }
        System.out.println(log.toAbsolutePath() + " " + log.toFile().exists() + " " + log.toFile().toPath()
                .equals(log));
    }

    private static void folders() throws IOException {
        Path folder = Files.createDirectories(Paths.get("a", "b", "c"));
        Files.createFile(folder.resolve("z.txt"));
        Files.createFile(folder.resolve("y.csv"));
        Files.createFile(folder.getParent().resolve("x.txt"));
        try (Stream<Path> all = Files.walk(Path.of("a"))) {
            System.out.println(all.map(Path::toString).collect(Collectors.joining(" ")));
        }
        List<String> found = new ArrayList<>();
        try (DirectoryStream<Path> texts = Files.newDirectoryStream(folder, "*.{txt,doc}")) {
            texts.forEach(path -> found.add(path.getFileName().toString()));
        }
        System.out.println(found + " " + Files.isDirectory(folder) + Files.isRegularFile(folder)
                + Files.exists(folder.resolve("q")));
        System.out.println(Files.getLastModifiedTime(folder) + " " + Files.isSameFile(folder, folder.resolve("../c")));
    }

    private static void copies() throws IOException {
        Path copy = Files.copy(Path.of("log.txt"), Path.of("copy.txt"));
        try {
            Files.copy(Path.of("log.txt"), copy);
        } catch (FileAlreadyExistsException e) {
            System.out.println("there: " + e.getMessage());
        }
        Files.move(copy, Path.of("w.txt"), StandardCopyOption.REPLACE_EXISTING);
        System.out.println(Files.exists(copy) + " " + Files.size(Path.of("w.txt")));
        System.out.println(Files.deleteIfExists(Path.of("w.txt")) + " " + Files.deleteIfExists(Path.of("w.txt")));
        try {
            Files.delete(Path.of("w.txt"));
        } catch (NoSuchFileException e) {
            System.out.println("none: " + e.getMessage());
        }
        Files.copy(new java.io.ByteArrayInputStream(new byte[5]), Path.of("five"));
        System.out.println(Files.readAllBytes(Path.of("five")).length + " "
                + Files.mismatch(Path.of("five"), Path.of("log.txt")));
    }

    private static void channels() throws IOException {
        try (FileChannel channel = FileChannel.open(Path.of("c.bin"), StandardOpenOption.CREATE,
                StandardOpenOption.READ,
                StandardOpenOption.WRITE)) {
            channel.write(ByteBuffer.wrap(new byte[] {1, 2, 3, 4}));
            channel.position(1);
            ByteBuffer two = ByteBuffer.allocate(2);
            channel.read(two);
            System.out.println(Arrays.toString(two.array()) + " " + channel.position() + " of " + channel.size());
            channel.map(FileChannel.MapMode.READ_ONLY, 0, 4);
        } catch (UnsupportedOperationException e) {
            System.out.println(e.getMessage());
        }
    }

    private static void others() throws IOException {
        System.out.println(Files.createTempFile("t", ".x") + " " + Files.createTempDirectory("d"));
        System.out.println(FileSystems.getDefault().getPath("/tmp").equals(Path.of(Path.of("/tmp").toUri())));
        System.out.println(Files.exists(Path.of("/etc/passwd")) + " " + Files.exists(Path.of("/proc")));
        System.out.println(Files.getFileStore(Path.of("/")).getUsableSpace() <= Files.getFileStore(Path.of("/"))
                .getTotalSpace());
    }
}
