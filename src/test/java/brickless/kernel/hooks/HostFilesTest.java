package brickless.kernel.hooks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileNotFoundException;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Without a kernel, as in this JVM, the classes that stand for those of {@code java.io} use the host's files. */
class HostFilesTest {
    @TempDir Path folder;

    private ProgramFile file(String name) {
        return new ProgramFile(folder.toString(), name);
    }

    @Test
    void streamsWriteAndReadFilesOfTheHost() throws IOException {
        try (ProgramFileOutputStream out = new ProgramFileOutputStream(file("a"))) {
            out.write(65);
        }
        try (ProgramFileWriter writer = new ProgramFileWriter(file("a"), true)) {
            writer.write("ä");
        }
        assertThat(folder.resolve("a")).hasContent("Aä");
        try (BufferedReader reader = new BufferedReader(new ProgramFileReader(file("a")))) {
            assertThat(reader.readLine()).isEqualTo("Aä");
        }
        try (ProgramRandomAccessFile table = new ProgramRandomAccessFile(file("a"), "rw")) {
            table.seek(1);
            table.writeBytes("BC");
        }
        assertThat(folder.resolve("a")).hasContent("ABC");
    }

    @Test
    void filesAreTheHosts() throws IOException {
        assertThat(file("new").createNewFile()).isTrue();
        assertThat(file("sub/deep").mkdirs()).isTrue();
        assertThat(Arrays.stream(folder.toFile().list())).containsExactlyInAnyOrder("new", "sub");
        assertThat(file("new").renameTo(file("old"))).isTrue();
        assertThat(file("old").listFiles()).isNull();
        assertThat(file("old").getAbsoluteFile()).isEqualTo(folder.resolve("old").toFile());
        assertThat(file("old").delete()).isTrue();
        assertThat(new ProgramFile("relative").getAbsolutePath()).isEqualTo(new File("relative").getAbsolutePath());
        assertThat(file("sub").toURI()).isEqualTo(folder.resolve("sub").toUri());
    }

    @Test
    void pathsAreTheHosts() throws IOException {
        assertThat(FileHooks.fileSystem()).isSameAs(FileSystems.getDefault());
        assertThat(FileHooks.path("a", "b")).isEqualTo(Path.of("a", "b"));
        assertThat(FileHooks.path(folder.toUri())).isEqualTo(folder);
        assertThat(FileHooks.toFile(folder)).isEqualTo(folder.toFile());
        assertThat(Files.exists(FileHooks.createTempFile(folder, "a", "b"))).isTrue();
        assertThat(Files.isDirectory(FileHooks.createTempDirectory(folder, "a"))).isTrue();
    }

    @Test
    void descriptorsAreSynchronised() throws IOException {
        try (FileOutputStream out = new FileOutputStream(folder.resolve("a").toFile())) {
            FileHooks.sync(out.getFD());
        }
        assertThatThrownBy(() -> FileHooks.sync(new FileDescriptor())).isInstanceOf(IOException.class);
    }

    @Test
    void missingFilesHaveTheMessageOfJavaIo() {
        assertThatThrownBy(() -> new ProgramFileInputStream(file("absent"))).isInstanceOf(FileNotFoundException.class)
                .hasMessage(folder.resolve("absent") + " (No such file or directory)");
    }

    @Test
    void jdkClassesMayOpenFilesByThemselves() {
        assertThat(FileHooks.hostOnly("x.zip")).isEqualTo("x.zip");
        assertThat(FileHooks.hostOnly(new File("x.zip"))).isEqualTo(new File("x.zip"));
        assertThat(FileHooks.hostOnly(true)).isTrue();
        assertThat(FileHooks.hostOnly(7)).isEqualTo(7);
    }
}
