package brickless;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackages;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.PackageMatchers;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.Location;
import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lejos.robotics.subsumption.Arbitrator;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** The package table of {@code sim/docs/ARCHITECTURE.md}, held against the compiled classes. */
class ArchitectureTest {
    private static final Path HOME = Path.of(System.getProperty("brickless.home"));
    private static final String[] JDK = {"java..", "javax.."};
    /** Package (with its subpackages unless it has its own row) and what it may use besides itself and the JDK. */
    private static final Map<String, List<String>> TABLE = new LinkedHashMap<>();
    private static JavaClasses all;

    static {
        TABLE.put("lejos", List.of("lejos..", "brickless.hardware", "org.slf4j.."));
        TABLE.put("brickless.hardware", List.of());
        TABLE.put("brickless.files", List.of());
        TABLE.put("brickless.kernel.hooks", List.of("brickless.files"));
        TABLE.put("brickless.kernel", List.of("brickless.kernel.hooks", "brickless.files"));
        TABLE.put("brickless.concurrent", List.of("brickless.concurrent..", "brickless.kernel.hooks"));
        TABLE.put("brickless.loading", List.of("brickless.loading..", "brickless.kernel.hooks", "org.objectweb.asm.."));
        TABLE.put("brickless.units", List.of());
        TABLE.put("brickless.world", List.of());
        TABLE.put("brickless.world.svg",
                List.of("brickless.world", "brickless.units", "org.locationtech.jts..", "org.w3c..", "org.xml.."));
        TABLE.put("brickless.physics", List.of("brickless.world", "brickless.units", "org.jbox2d.."));
        TABLE.put("brickless.device", List.of("brickless.device..", "brickless.hardware", "brickless.physics",
                "brickless.kernel", "brickless.world", "brickless.units"));
        TABLE.put("brickless.trace", List.of("brickless.world", "brickless.units", "com.fasterxml.jackson.."));
        TABLE.put("brickless.program", List.of("brickless.loading"));
        TABLE.put("brickless.simulation", List.of("brickless.files", "brickless.hardware", "brickless.kernel",
                "brickless.kernel.hooks", "brickless.loading..", "brickless.units", "brickless.world..",
                "brickless.physics", "brickless.device..", "brickless.trace", "brickless.program", "org.slf4j.."));
        TABLE.put("brickless.junit",
                List.of("brickless.simulation", "brickless.program", "brickless.world", "brickless.world.svg",
                        "org.junit.jupiter.api..", "org.junit.platform.commons.support", "org.opentest4j"));
        TABLE.put("brickless.junit.brick", List.of("org.junit.jupiter.api", "org.junit.platform.commons.support"));
        TABLE.put("brickless.viewer",
                List.of("brickless.simulation", "brickless.program", "brickless.trace", "brickless.world",
                        "com.sun.net.httpserver"));
        TABLE.put("brickless.cli", List.of("brickless.kernel", "brickless.simulation", "brickless.program",
                "brickless.world", "brickless.trace", "brickless.loading", "brickless.viewer", "picocli.."));
    }

    @BeforeAll
    static void importClasses() {
        all = new ClassFileImporter().importLocations(List.of(Location.of(mainClasses())));
        assertThat(all.size()).as("classes found").isGreaterThan(100);
    }

    private static URI mainClasses() {
        try {
            return Arbitrator.class.getProtectionDomain().getCodeSource().getLocation().toURI();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    @TestFactory
    Stream<DynamicTest> everyPackageUsesOnlyWhatItsRowAllows() {
        return TABLE.entrySet().stream()
                .map(row -> DynamicTest.dynamicTest(row.getKey(), () -> check(row.getKey(), row.getValue())));
    }

    private static void check(String name, List<String> allowed) {
        List<String> targets = new ArrayList<>(allowed);
        targets.addAll(List.of(JDK));
        targets.add(name);
        List<String> ownRows = TABLE.keySet().stream().filter(other -> other.startsWith(name + "."))
                .map(other -> other + "..").toList();
        classes().that(resideInAPackage(name + "..").and(resideOutsideOfPackages(ownRows.toArray(String[]::new))))
                .should().onlyDependOnClassesThat(liveIn(targets)).allowEmptyShould(true).check(all);
    }

    private static DescribedPredicate<JavaClass> liveIn(List<String> packages) {
        PackageMatchers matchers = PackageMatchers.of(packages);
        return DescribedPredicate.describe("are primitive or live in " + packages,
                type -> type.getBaseComponentType().isPrimitive()
                        || matchers.test(type.getBaseComponentType().getPackageName()));
    }

    @Test
    void everyPackageHasARow() {
        assertThat(all.stream().map(JavaClass::getPackageName).distinct()
                .filter(name -> TABLE.keySet().stream()
                        .noneMatch(row -> name.equals(row) || name.startsWith(row + "."))))
                .as("packages without a row in the table").isEmpty();
    }

    @Test
    void theTableInTheDocumentationHasTheSameRows() throws IOException {
        Pattern row = Pattern.compile("\\| `([a-z.]+?)(\\.\\*+)?` \\|.*");
        assertThat(Files.readAllLines(HOME.resolve("sim/docs/ARCHITECTURE.md")).stream().map(row::matcher)
                .filter(Matcher::matches).map(found -> found.group(1)))
                .containsExactlyInAnyOrderElementsOf(TABLE.keySet());
    }

    @Test
    void noPackageCycles() {
        slices().matching("brickless.(**)").should().beFreeOfCycles().check(all);
    }

    @Test
    void theSimulatorNeverReadsTheWallClock() {
        noClasses().that().resideInAPackage("brickless..").and()
                .resideOutsideOfPackages("brickless.kernel", "brickless.kernel.hooks", "brickless.concurrent..",
                        "brickless.cli", "brickless.viewer..")
                .and().haveSimpleNameNotContaining("WallClock")
                .should().callMethod(System.class, "currentTimeMillis").orShould().callMethod(System.class, "nanoTime")
                .orShould().callMethod(Thread.class, "sleep", long.class).orShould().callMethod(Math.class, "random")
                .orShould().callConstructor(java.util.Random.class).check(all);
    }

    @Test
    void everyPackageSaysItsJob() throws IOException {
        try (Stream<Path> files = Files.walk(HOME.resolve("src/main/java"))) {
            List<Path> silent = files.filter(file -> file.toString().endsWith(".java")).map(Path::getParent).distinct()
                    .filter(folder -> !Files.exists(folder.resolve("package-info.java"))).toList();
            assertThat(silent).as("packages without package-info.java").isEmpty();
        }
    }
}
