package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileWatchTest {
    @TempDir Path folder;
    private Path one;
    private Path two;
    private FileWatch watch;

    @BeforeEach
    void write() throws IOException {
        one = write("one.txt", "one", 1);
        two = write("two.txt", "two", 1);
        watch = new FileWatch(List.of(one, two));
    }

    private Path write(String name, String content, long time) throws IOException {
        Path file = Files.writeString(folder.resolve(name), content);
        return Files.setLastModifiedTime(file, FileTime.fromMillis(time));
    }

    @Test
    void filesThatStayAsTheyAreDidNotChange() {
        assertThat(watch.changed()).isEmpty();
    }

    @Test
    void anotherContentIsAChangeUntilItIsTakenBack() throws IOException {
        write("two.txt", "TWO", 2);
        assertThat(watch.changed()).containsExactly(two);
        write("one.txt", "other", 2);
        assertThat(watch.changed()).containsExactly(one, two);
        write("two.txt", "two", 3);
        assertThat(watch.changed()).containsExactly(one);
    }

    @Test
    void anotherTimeAloneIsNoChange() throws IOException {
        write("one.txt", "one", 99);
        assertThat(watch.changed()).isEmpty();
    }

    @Test
    void aFileThatWentIsAChangeUntilItIsBack() throws IOException {
        Files.delete(one);
        assertThat(watch.changed()).containsExactly(one);
        write("one.txt", "one", 5);
        assertThat(watch.changed()).isEmpty();
    }

    @Test
    void aFileThatWasNotThereMayCome() throws IOException {
        FileWatch early = new FileWatch(List.of(folder.resolve("three.txt")));
        assertThat(early.changed()).isEmpty();
        Path three = write("three.txt", "", 1);
        assertThat(early.changed()).containsExactly(three);
    }
}
