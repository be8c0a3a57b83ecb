package brickless.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.FileChannel;
import java.nio.channels.NonReadableChannelException;
import java.nio.channels.NonWritableChannelException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The tree of a brick's files, without a program. */
class BrickFilesTest {
    private static final OpenOption[] WRITE = {StandardOpenOption.WRITE, StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING};

    @TempDir Path host;
    private long now = 1000;
    private final BrickFiles files = new BrickFiles(1000, () -> now);

    private void write(String path, int... values) throws IOException {
        try (FileChannel channel = files.open(path, Set.of(WRITE))) {
            channel.write(ByteBuffer.wrap(bytes(values)));
        }
    }

    private static byte[] bytes(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        return bytes;
    }

    @Test
    void aFreshBrickHasItsFoldersAndNoFiles() throws IOException {
        assertThat(files.list("/")).containsExactly("home", "tmp");
        assertThat(files.list("/home/lejos")).containsExactly("lib", "programs", "samples");
        assertThat(files.list("")).isEmpty();
        assertThat(files.written()).isEmpty();
        assertThat(files.freeBytes()).isEqualTo(BrickFiles.CAPACITY_BYTES);
    }

    @Test
    void oneFileHasManyNames() throws IOException {
        write("a.txt", 1, 2);
        for (String name : List.of("a.txt", "./a.txt", "/home/lejos/programs/a.txt", "../programs/a.txt",
                "/../home/lejos/./programs//a.txt")) {
            assertThat(files.read(name)).as(name).containsExactly(1, 2);
        }
        assertThat(files.written()).containsExactly(Map.entry("/home/lejos/programs/a.txt", 2));
    }

    @Test
    void writingBehindTheEndLeavesZeros() throws IOException {
        try (FileChannel channel = files.open("a", Set.of(WRITE))) {
            channel.write(ByteBuffer.wrap(bytes(9, 9, 9, 9)));
            channel.truncate(1);
            channel.position(3).write(ByteBuffer.wrap(bytes(7)));
        }
        assertThat(files.read("a")).as("what was cut off does not come back").containsExactly(9, 0, 0, 7);
    }

    @Test
    void appendingWritesAtTheEndWhereverThePositionIs() throws IOException {
        write("a", 1);
        try (FileChannel channel = files.open("a", Set.of(StandardOpenOption.APPEND))) {
            channel.position(0).write(ByteBuffer.wrap(bytes(2)));
            write("a", 5, 6, 7);
            channel.write(ByteBuffer.wrap(bytes(3)));
        }
        assertThat(files.read("a")).containsExactly(5, 6, 7, 3);
    }

    @Test
    void filesHaveTheDateOfTheirLastWrite() throws IOException {
        now = 2000;
        write("a", 1);
        now = 3000;
        files.read("a");
        assertThat(files.modifiedMillis("a")).isEqualTo(2000);
        assertThat(files.modifiedMillis("")).as("the folder got an entry then").isEqualTo(2000);
        assertThat(files.modifiedMillis("/tmp")).as("as at the start").isEqualTo(1000);
        assertThat(files.modifiedMillis("absent")).isZero();
    }

    @Test
    void roomIsTakenAndGivenBack() throws IOException {
        write("a", new int[100]);
        assertThat(files.freeBytes()).isEqualTo(BrickFiles.CAPACITY_BYTES - 100);
        write("a", 1);
        files.copy("a", "b", false);
        assertThat(files.freeBytes()).isEqualTo(BrickFiles.CAPACITY_BYTES - 2);
        files.move("a", "b", true);
        assertThat(files.freeBytes()).isEqualTo(BrickFiles.CAPACITY_BYTES - 1);
        files.delete("b");
        assertThat(files.freeBytes()).isEqualTo(BrickFiles.CAPACITY_BYTES);
    }

    @Test
    void nothingFitsBeyondTheCapacity() throws IOException {
        try (FileChannel channel = files.open("a", Set.of(WRITE))) {
            for (long position : new long[] {BrickFiles.CAPACITY_BYTES, Long.MAX_VALUE - 1, 1L << 40}) {
                assertThatThrownBy(() -> channel.write(ByteBuffer.allocate(1), position)).as("at " + position)
                        .isInstanceOf(IOException.class).hasMessage("No space left on device");
            }
            channel.write(ByteBuffer.allocate(1), 9);
        }
        assertThat(files.length("a")).isEqualTo(10);
        assertThat(files.freeBytes()).isEqualTo(BrickFiles.CAPACITY_BYTES - 10);
    }

    @Test
    void aDeletedFileLivesOnForWhoHasItOpen() throws IOException {
        try (FileChannel channel = files.open("a", Set.of(StandardOpenOption.CREATE, StandardOpenOption.READ,
                StandardOpenOption.WRITE))) {
            channel.write(ByteBuffer.wrap(bytes(1, 2)));
            files.delete("a");
            channel.write(ByteBuffer.wrap(bytes(3)));
            ByteBuffer read = ByteBuffer.allocate(3);
            assertThat(channel.read(read, 0)).isEqualTo(3);
            assertThat(files.exists("a")).isFalse();
        }
        assertThat(files.freeBytes()).isEqualTo(BrickFiles.CAPACITY_BYTES);
    }

    @Test
    void channelsDoWhatTheyWereOpenedFor() throws IOException {
        write("a", 1, 2, 3);
        FileChannel reader = files.open("a", Set.of(StandardOpenOption.READ));
        assertThatThrownBy(() -> reader.write(ByteBuffer.allocate(1))).isInstanceOf(NonWritableChannelException.class);
        reader.close();
        assertThatThrownBy(() -> reader.read(ByteBuffer.allocate(1))).isInstanceOf(ClosedChannelException.class);
        try (FileChannel writer = files.open("a", Set.of(StandardOpenOption.WRITE))) {
            assertThatThrownBy(() -> writer.read(ByteBuffer.allocate(1)))
                    .isInstanceOf(NonReadableChannelException.class);
            assertThatThrownBy(() -> writer.position(-1)).isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(writer::lock).isInstanceOf(UnsupportedOperationException.class);
            assertThatThrownBy(() -> writer.map(FileChannel.MapMode.READ_WRITE, 0, 1))
                    .isInstanceOf(UnsupportedOperationException.class);
        }
        assertThatThrownBy(() -> files.open("a", Set.of(StandardOpenOption.APPEND, StandardOpenOption.READ)))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void channelsCopyToEachOther() throws IOException {
        write("a", new int[20_000]);
        try (FileChannel from = files.open("a", Set.of(StandardOpenOption.READ)); FileChannel to =
                files.open("b", Set.of(WRITE))) {
            assertThat(to.transferFrom(from, 0, Long.MAX_VALUE)).isEqualTo(20_000);
            assertThat(from.transferTo(19_990, 100, to)).isEqualTo(10);
        }
        assertThat(files.length("b")).isEqualTo(20_000);
    }

    @Test
    void aFileThatIsDeletedAtItsEndGoes() throws IOException {
        files.open("a", Set.of(StandardOpenOption.CREATE, StandardOpenOption.WRITE,
                StandardOpenOption.DELETE_ON_CLOSE)).close();
        assertThat(files.exists("a")).isFalse();
        files.createFolder("d");
        write("d/b", 1);
        files.deleteAtEnd("d");
        files.deleteAtEnd("d/b");
        files.deleteAtEnd("never made");
        files.end();
        assertThat(files.list("")).isEmpty();
    }

    @Test
    void whatCannotBeIsRefusedInTheTermsOfTheJdk() throws IOException {
        write("file", 1);
        files.createFolder("folder");
        write("folder/inside", 1);
        assertThatThrownBy(() -> files.open("absent", Set.of(StandardOpenOption.READ)))
                .isInstanceOf(NoSuchFileException.class).hasMessage("absent");
        assertThatThrownBy(() -> files.open("folder", Set.of(WRITE))).isInstanceOf(FileSystemException.class)
                .hasMessage("folder: Is a directory");
        assertThatThrownBy(() -> files.open("file", Set.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)))
                .isInstanceOf(FileAlreadyExistsException.class);
        assertThatThrownBy(() -> files.open("absent/file", Set.of(WRITE))).isInstanceOf(NoSuchFileException.class);
        assertThatThrownBy(() -> files.open("file/file", Set.of(WRITE))).hasMessage("file/file: Not a directory");
        assertThatThrownBy(() -> files.createFolder("folder")).isInstanceOf(FileAlreadyExistsException.class);
        assertThatThrownBy(() -> files.delete("folder")).isInstanceOf(DirectoryNotEmptyException.class);
        assertThatThrownBy(() -> files.delete("/")).isInstanceOf(DirectoryNotEmptyException.class);
        assertThatThrownBy(() -> files.delete("absent")).isInstanceOf(NoSuchFileException.class);
        assertThatThrownBy(() -> files.list("file")).isInstanceOf(NotDirectoryException.class);
        assertThatThrownBy(() -> files.copy("file", "folder", true)).isInstanceOf(DirectoryNotEmptyException.class);
        assertThatThrownBy(() -> files.move("folder", "folder/inside/deeper", false))
                .hasMessageContaining("Invalid argument");
        assertThatThrownBy(() -> files.read("folder")).hasMessage("folder: Is a directory");
        assertThat(files.read("folder/inside")).as("untouched").containsExactly(1);
    }

    @Test
    void anOriginalIsReadAndNeverWritten() throws IOException {
        Path original = Files.write(host.resolve("original"), bytes(1, 2, 3));
        files.put("gifts/a", original, 3);
        assertThat(files.length("gifts/a")).isEqualTo(3);
        assertThat(files.written()).isEmpty();
        assertThat(files.modifiedMillis("gifts/a")).as("not the host's date").isEqualTo(1000);
        try (FileChannel channel = files.open("gifts/a", Set.of(StandardOpenOption.WRITE))) {
            channel.write(ByteBuffer.wrap(bytes(9)), 1);
        }
        assertThat(files.read("gifts/a")).containsExactly(1, 9, 3);
        assertThat(files.written()).containsExactly(Map.entry("/home/lejos/programs/gifts/a", 3));
        assertThat(files.freeBytes()).isEqualTo(BrickFiles.CAPACITY_BYTES - 3);
        assertThat(Files.readAllBytes(original)).containsExactly(1, 2, 3);
    }

    @Test
    void anOriginalUnderAnotherNameIsTheProgramsFile() throws IOException {
        files.put("d/a", Files.write(host.resolve("original"), bytes(1, 2)), 2);
        files.move("d", "e", false);
        assertThat(files.written()).containsExactly(Map.entry("/home/lejos/programs/e/a", 2));
        assertThat(files.exists("d")).isFalse();
    }

    @Test
    void anOriginalThatIsGoneIsAnErrorOfInput() throws IOException {
        Path original = Files.write(host.resolve("original"), bytes(1));
        files.put("a", original, 1);
        Files.delete(original);
        assertThatThrownBy(() -> files.read("a")).isInstanceOf(IOException.class);
    }
}
