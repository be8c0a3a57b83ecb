package lejos;

import static org.assertj.core.api.Assertions.assertThat;

import japicmp.cmp.JApiCmpArchive;
import japicmp.cmp.JarArchiveComparator;
import japicmp.cmp.JarArchiveComparatorOptions;
import japicmp.config.Options;
import japicmp.model.AccessModifier;
import japicmp.model.JApiChangeStatus;
import japicmp.model.JApiClass;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lejos.robotics.subsumption.Arbitrator;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Compares every public and protected name under {@code lejos}, without {@code lejos.internal}, with the published jar.
 * Two text files beside this class are the memory of what differs: {@code absent-classes.txt} can only shrink, {@code
 * added-members.txt} lists what we add on purpose.
 */
class SignatureTest {
    private static List<JApiClass> classes;

    @BeforeAll
    static void compare(@TempDir Path folder) throws IOException, URISyntaxException {
        Path ours = folder.resolve("ours.jar");
        pack(Path.of(Arbitrator.class.getProtectionDomain().getCodeSource().getLocation().toURI()), ours);
        Options options = Options.newDefault();
        options.setIgnoreMissingClasses(true);
        options.setAccessModifier(AccessModifier.PROTECTED);
        options.setNoAnnotations(true);
        classes = new JarArchiveComparator(JarArchiveComparatorOptions.of(options)).compare(
                        new JApiCmpArchive(OriginalJar.path().toFile(), "original"),
                        new JApiCmpArchive(ours.toFile(), "ours"))
                .stream().filter(c -> published(c.getFullyQualifiedName())).toList();
    }

    /** Internals keep the names that programs mention, but their members belong to the virtual brick. */
    private static boolean published(String name) {
        return name.startsWith("lejos.") && !name.startsWith("lejos.internal.");
    }

    @Test
    void nothingOfAPresentClassIsMissingOrChanged() {
        assertThat(present().flatMap(c -> SignatureDifference.of(c).stream()).filter(d -> !d.isAddition())
                .map(Object::toString)).isEmpty();
    }

    @Test
    void additionsAreListed() {
        Set<String> added = classes.stream().filter(c -> c.getChangeStatus() == JApiChangeStatus.NEW)
                .filter(c -> SignatureDifference.visible(c.getAccessModifier().getNewModifier()))
                .map(JApiClass::getFullyQualifiedName).collect(Collectors.toCollection(TreeSet::new));
        present().flatMap(c -> SignatureDifference.of(c).stream()).filter(SignatureDifference::isAddition)
                .map(Object::toString).forEach(added::add);
        assertThat(added).containsExactlyInAnyOrderElementsOf(listed("added-members.txt"));
    }

    @Test
    void absentClassesAreListed() {
        assertThat(listed("absent-classes.txt")).as("nothing may be added to the list").containsAll(absent());
    }

    @Test
    void listedClassesAreAbsent() {
        assertThat(absent()).as("remove from the list what exists or was never public")
                .containsAll(listed("absent-classes.txt"));
    }

    private static Set<String> absent() {
        return classes.stream().filter(c -> c.getChangeStatus() == JApiChangeStatus.REMOVED)
                .filter(c -> SignatureDifference.visible(c.getAccessModifier().getOldModifier()))
                .map(JApiClass::getFullyQualifiedName).collect(Collectors.toCollection(TreeSet::new));
    }

    private static Stream<JApiClass> present() {
        return classes.stream().filter(c -> c.getOldClass().isPresent() && c.getNewClass().isPresent());
    }

    private static List<String> listed(String resource) {
        try (var stream = SignatureTest.class.getResourceAsStream(resource)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8).lines()
                    .map(String::strip).filter(line -> !line.isEmpty() && !line.startsWith("#")).toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void pack(Path classesFolder, Path jar) throws IOException {
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar));
                Stream<Path> files = Files.walk(classesFolder.resolve("lejos"))) {
            for (Path file : files.filter(f -> f.toString().endsWith(".class")).sorted().toList()) {
                out.putNextEntry(new JarEntry(classesFolder.relativize(file).toString().replace('\\', '/')));
                Files.copy(file, out);
            }
        }
    }
}
