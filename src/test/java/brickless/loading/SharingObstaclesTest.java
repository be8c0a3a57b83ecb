package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassReader;

/** What keeps robots from sharing their classes. */
class SharingObstaclesTest {
    private static Optional<String> obstacleOf(String... mainClasses) {
        return SharingObstacles.firstIn(RobotClassLoader.ofApplication(), List.of(mainClasses));
    }

    @Test
    void plainProgramsHaveNone() {
        assertThat(obstacleOf("programs.speed.Bumper")).isEmpty();
        assertThat(obstacleOf("programs.passing.statics.MutableEnums")).isEmpty();
    }

    @Test
    void setsOfEnumConstantsAreOne() {
        assertThat(obstacleOf("programs.passing.initialisers.EnumConstants")).get().asString()
                .startsWith("programs.passing.initialisers.EnumConstants uses java/");
    }

    @Test
    void oneInAClassThatTheMainClassLeadsToCounts() {
        assertThat(obstacleOf("programs.speed.Bumper", "programs.passing.initialisers.ByReflection")).get().asString()
                .contains("java/lang/Class.forName");
    }

    @Test
    void aMissingMainClassIsOne() {
        assertThat(obstacleOf("programs.Missing")).hasValue("no class programs.Missing on the class path");
    }

    @Test
    void ourOwnClassesThatRobotsShareHaveNone() throws IOException {
        Path classes = Path.of(java.net.URI.create(RobotClassLoader.class.getProtectionDomain().getCodeSource()
                .getLocation().toString()));
        List<String> obstacles = new ArrayList<>();
        for (String ours : List.of("lejos", "brickless/concurrent", "brickless/junit/brick")) {
            try (Stream<Path> files = Files.walk(classes.resolve(ours))) {
                for (Path file : files.filter(path -> path.toString().endsWith(".class")).toList()) {
                    new ClassReader(Files.readAllBytes(file)).accept(new ReferenceReader((reference, user, line) -> {
                        if (SharingObstacles.isOne(reference)) {
                            obstacles.add(user + " " + reference.owner() + "." + reference.member());
                        }
                    }), 0);
                }
            }
        }
        String startsWhatWasLookedAt =
                "(lejos/internal/ev3/EV3Wrapper|brickless/junit/brick/TestCall) java/lang/Class.forName.*";
        String onlyForProgramsThatUseStreams = "brickless/concurrent/util/Hashtable java/io/Object.*";
        assertThat(obstacles).allMatch(use -> use.matches(startsWhatWasLookedAt + "|" + onlyForProgramsThatUseStreams));
    }
}
