package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import brickless.simulation.Run;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import kit.Buttons;
import kit.Menu;
import kit.Signals;
import kit.Volts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whole programs that use keys, menu, LEDs, loudspeaker and battery. */
class PanelRunsTest {
    @Test
    void keysArePressesThatTheProgramCanMiss() {
        try (Run run = Kit.run(Buttons.class, Kit.EMPTY, Kit.BENCH, Kit.stimuli("1s press ENTER 200ms",
                "1600ms press LEFT 100ms",
                "1950ms press RIGHT 1000ms", "4s press RIGHT 200ms", "5s press UP 300ms", "7s press DOWN 200ms",
                        "8s press DOWN 150ms",
                "9s press ENTER 150ms", "10s press ESCAPE 150ms"))) {
            Printed lines = Kit.printed(run);
            pressed(lines, "first", 2, 1000);
            assertThat(lines.words("timeout").get(0)).as("LEFT came after the time-out").isEqualTo("0");
            assertThat(lines.number("timeout")).isZero();
            assertThat(lines.words("lost")).containsExactly("8");
            pressed(lines, "heldBefore", 8, 2000);
            pressed(lines, "pressedAnew", 8, 4000);
            pressed(lines, "released", 8 << 8, 4200);
            pressed(lines, "pressed", 1, 5000);
            pressed(lines, "downAndUp", 0, 7200);
            pressed(lines, "menu", 1, 9000);
            pressed(lines, "escape", -1, 10_000);
        }
    }

    /** Within 160 ms of a moment: a poll, debouncing and the click. */
    private static void pressed(Printed lines, String name, int value, int millis) {
        assertThat(lines.numbers(name)[0]).as(name).isEqualTo(value);
        assertThat(lines.numbers(name)[1]).as(name).isBetween((double) millis, millis + 160.0);
    }

    @Test
    void theMenuIsOnTheScreenWhileItWaits() {
        SimulationSettings settings = SimulationSettings.builder(Kit.worldOf(Kit.EMPTY)).robot(Kit.robotOf(Kit.BENCH))
                .build();
        try (Run run = new Simulation(settings).start(Menu.class)) {
            assertThat(run.advanceUntil(each -> each.robot().screenText().contains("stop"), Duration.ofSeconds(30)))
                    .isTrue();
            assertThat(run.robot().screenText()).isEqualTo("choose\n>drive\n turn\n stop");
        }
    }

    @Test
    void soundsBlockForTheirLengthAndAreTraced(@TempDir Path folder) throws IOException {
        try (Run run = Kit.run(Signals.class, Kit.EMPTY, Kit.BENCH,
                settings -> settings.out(Optional.of(folder.resolve("run"))))) {
            Printed lines = Kit.printed(run);
            String[] lengths = {"beep 200", "twoBeeps 350", "sequence 400", "sequenceUp 400", "buzz 500", "tone 250",
                    "absolute 30",
                "sample 1500"};
            for (String length : lengths) {
                String[] parts = length.split(" ");
                assertThat(lines.number(parts[0])).as(parts[0]).isBetween(Double.parseDouble(parts[1]),
                        Double.parseDouble(parts[1]) + 3);
            }
            assertThat(lines.words("volume")).containsExactly("80");
            assertThat(lines.words("result")).containsExactly("0");
            assertThat(lines.words("missing")).containsExactly("-9");
        }
        List<String> sounds = sounds(folder.resolve("run").resolve("trace.jsonl"));
        assertThat(sounds.subList(0, 3)).containsExactly("600 Hz 200 ms 80 %", "600 Hz 150 ms 80 %",
                "600 Hz 150 ms 80 %");
        assertThat(sounds.subList(3, 7)).containsExactly("915 Hz 100 ms 80 %", "784 Hz 100 ms 80 %",
                "653 Hz 100 ms 80 %",
                "523 Hz 100 ms 80 %");
        assertThat(sounds.subList(11, 15)).containsExactly("100 Hz 500 ms 80 %", "440 Hz 250 ms 30 %",
                "880 Hz 30 ms 70 %",
                "0 Hz 1500 ms 50 %");
    }

    private static List<String> sounds(Path trace) throws IOException {
        Pattern sound = Pattern.compile("\"hertz\":(\\d+).*\"millis\":(\\d+).*\"volume\":(\\d+)");
        return Files.readAllLines(trace).stream().map(sound::matcher).filter(Matcher::find)
                .map(found -> found.group(1) + " Hz " + found.group(2) + " ms " + found.group(3) + " %").toList();
    }

    @Test
    void ledPatternsAreTraced(@TempDir Path folder) throws IOException {
        try (Run run = Kit.run(Signals.class, Kit.EMPTY, Kit.BENCH,
                settings -> settings.out(Optional.of(folder.resolve("run"))))) {
            assertThat(run.robot().ledPattern()).isZero();
        }
        assertThat(Files.readAllLines(folder.resolve("run").resolve("trace.jsonl")).stream()
                .filter(line -> line.contains("\"pattern\":"))
                .map(line -> line.replaceAll(".*\"pattern\":(\\d).*", "$1")).toList()).containsExactly("4", "0");
    }

    @Test
    void theBatterySagsUnderLoadAndRecovers() {
        try (Run run = Kit.run(Volts.class, Kit.EMPTY, Kit.BENCH, Kit.stimuli("1500ms battery 6.9V"))) {
            Printed lines = Kit.printed(run);
            double[] rest = lines.numbers("rest");
            double[] load = lines.numbers("load");
            assertThat(rest[0]).isCloseTo(8.2 - 0.17 * 0.15, offset(0.001));
            assertThat(rest[1]).isEqualTo(Math.floor(rest[0] * 1000));
            assertThat(load[2]).as("starting currents").isBetween(2.0, 3.2);
            assertThat(load[0]).isCloseTo(8.2 - load[2] * 0.15, offset(0.002));
            assertThat(lines.number("recovered")).isCloseTo(rest[0], offset(0.001));
            assertThat(lines.number("emptier")).isCloseTo(6.9 - 0.17 * 0.15, offset(0.001));
        }
    }
}
