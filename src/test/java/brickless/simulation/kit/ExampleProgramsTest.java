package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFinder;
import brickless.simulation.Run;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Programs of {@code sim/programs} that show one ability of the kit. */
class ExampleProgramsTest {
    /** Refresh only after looking at {@code screen.png}: every shape of the program must be there. */
    private static final String DRAWING = "c12a40e00b11a885147342f4b954acf53aa2e9a269040f3e1386e5a8c65dce6d";
    private static final Path PROGRAMS = Path.of(System.getProperty("brickless.home", ""), "sim", "programs");

    private static Run run(String folder, SimulationSettings.Builder settings) throws ProgramException {
        try (Program program = new ProgramFinder(PROGRAMS, List.of(), Optional.empty()).find(folder)) {
            Run run = new Simulation(settings.limit(Duration.ofSeconds(20)).build()).start(program);
            run.toEnd();
            return run;
        }
    }

    @Test
    void everyGraphicsOperationDrawsTheSamePictureEverywhere() throws ProgramException, NoSuchAlgorithmException {
        try (Run run = run("drawing", SimulationSettings.builder(Kit.worldOf(Kit.EMPTY)))) {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(run.robot().screenPng());
            assertThat(HexFormat.of().formatHex(hash)).isEqualTo(DRAWING);
        }
    }

    @Test
    void driversOfTheProgramWorkWithDevicesOfTheirKind() throws ProgramException, IOException {
        String robot = Files.readString(PROGRAMS.resolve("ownsensor").resolve("robot.svg"));
        try (Run run = run("ownsensor", SimulationSettings.builder(Kit.worldOf(Worlds.ROOM)).robot(Kit.robotOf(robot))
                .ideal(true))) {
            assertThat(run.outcome().kind()).isEqualTo("exited");
            assertThat(run.robot().screenText().lines()).contains("sonar mm 510.0", "sonar in 201.0", "ranger m 0.51",
                    "bumper 0.0", "closed",
                    "LEGO Sonar V1.0");
            assertThat(value(run, "bright")).isBetween(0.5, 0.65);
            assertThat(value(run, "dark")).isBetween(0.0, 0.2);
        }
    }

    private static double value(Run run, String name) {
        String line = run.robot().screenText().lines().filter(each -> each.startsWith(name)).findFirst().orElseThrow();
        return Double.parseDouble(line.substring(name.length()));
    }
}
