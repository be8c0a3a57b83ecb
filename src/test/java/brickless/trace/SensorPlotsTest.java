package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.browser.Browser;
import brickless.trace.RobotSample.SensorSample;
import brickless.world.Pose2;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sensors in a report: quantities and units of the modes that they were in, and words for states. */
@Tag("browser")
class SensorPlotsTest {
    private static final long SAMPLE_NANOS = 50_000_000;

    @TempDir static Path folder;
    private static Browser browser;

    @BeforeAll
    static void startTheBrowser() {
        browser = new Browser(1280, 720);
    }

    @AfterAll
    static void closeTheBrowser() {
        browser.close();
    }

    /** Opens the report of a run in which one sensor, in some mode, sent these values, one after the other. */
    private static void open(String kind, String mode, double[]... sent) throws IOException {
        open(kind, Map.of(0, mode), sent);
    }

    private static void open(String kind, Map<Integer, String> modes, double[]... sent) throws IOException {
        ReportRecording recording = new ReportRecording();
        recording.header(new TraceHeader("demo.Sensing", "hall", List.of("made-up"), 3, -1, false, 2_000_000,
                SAMPLE_NANOS));
        for (int i = 0; i < sent.length; i++) {
            if (modes.containsKey(i) && !modes.get(i).isEmpty()) {
                recording.event(i * SAMPLE_NANOS, SyntheticRun.ROBOT, new TraceEvent.ModeEvent(2, kind, modes.get(i)));
            }
            recording.sample(new Sample(i * SAMPLE_NANOS,
                    List.of(new RobotSample(SyntheticRun.ROBOT, new Pose2(0, 0, 0), List.of(),
                    List.of(new SensorSample(2, kind, sent[i])), 8)), List.of()));
        }
        Path page = folder.resolve(kind + ".html");
        try (OutputStream out = Files.newOutputStream(page)) {
            HtmlReport.write(out, recording, SyntheticRun.scene(), Optional.empty());
        }
        browser.open(page, "");
    }

    /**
     * At a sample: each plot of the sensor with its unit and its value, as the page shows them; then what the brick
     * shows.
     */
    private static List<String> shown(int sample) {
        browser.run("location.hash = '#t=" + sample * SAMPLE_NANOS / 1e9
                + "'; window.dispatchEvent(new HashChangeEvent('hashchange'))");
        List<String> shown = new ArrayList<>();
        for (Object text : (List<?>) browser.value(
                "[...document.querySelectorAll('.plots-panel .track')].filter((row) => !row.hidden "
                + "&& row.textContent.startsWith('S2')).map((row) => `${row.querySelector('.unit').textContent} = "
                + "${[...row.querySelectorAll('.reading')].map((one) => one.textContent).join(' ')}`)")) {
            shown.add((String) text);
        }
        shown.add((String) browser.value(
                "document.querySelector('.port-2').parentNode.querySelector('.port-value').textContent"));
        return shown;
    }

    private static double[] v(double... values) {
        return values;
    }

    @Test
    void distancesAreCentimetresOrNoEcho() throws IOException {
        open("ev3-ultrasonic", "US-DIST-CM", v(243), v(2550));
        assertThat(shown(0)).containsExactly("distance, cm = 24.3", "24.3 cm");
        assertThat(shown(1)).containsExactly("distance, cm = no echo", "no echo");
        open("ev3-ultrasonic", "US-DIST-IN", v(100));
        assertThat(shown(0)).containsExactly("distance, cm = 25.4", "25.4 cm");
        open("nxt-ultrasonic", "", v(31), v(255));
        assertThat(shown(0)).containsExactly("distance, cm = 31.0", "31.0 cm");
        assertThat(shown(1)).containsExactly("distance, cm = no echo", "no echo");
    }

    @Test
    void aGyroTellsAngleAndRate() throws IOException {
        open("ev3-gyro", "GYRO-G&A", v(-90, 12));
        assertThat(shown(0)).containsExactly("angle, ° clockwise = −90", "rate, °/s clockwise = 12", "−90° 12 °/s");
    }

    @Test
    void aColourSensorHasAPlotForEachModeThatItWasIn() throws IOException {
        open("ev3-color", Map.of(0, "COL-COLOR", 1, "COL-REFLECT", 2, "RGB-RAW", 3, "COL-COLOR"), v(5), v(43),
                v(300, 20, 7), v(2));
        assertThat(shown(0)).containsExactly("colour = red", "reflected light, % = –",
                "light parts, of 1020 = red– green– blue–", "red");
        assertThat(shown(1)).containsExactly("colour = –", "reflected light, % = 43",
                "light parts, of 1020 = red– green– blue–", "43 %");
        assertThat(shown(2)).containsExactly("colour = –", "reflected light, % = –",
                "light parts, of 1020 = red300 green20 blue7", "300 20 7");
        assertThat(shown(3)).first().isEqualTo("colour = blue");
        assertThat(browser.value("[...document.querySelectorAll('.plots-panel .chip')].map((chip) => "
                + "chip.textContent).filter((text) => text.startsWith('S2'))"))
                .isEqualTo(List.of("S2 colour", "S2 reflected light", "S2 light parts"));
    }

    @Test
    void aTouchSensorIsPressedOrReleased() throws IOException {
        open("ev3-touch", "", v(0), v(1));
        assertThat(shown(0)).containsExactly(" = released", "released");
        assertThat(shown(1)).containsExactly(" = pressed", "pressed");
    }

    @Test
    void statesArePaintedAsBlocks() throws IOException {
        open("ev3-touch", "", v(0), v(1), v(1), v(0), v(0));
        String look = "(() => { const c = document.querySelector('.plots-panel .track:not([hidden]) canvas'); const at "
                + "= (part) => "
                + "c.getContext('2d').getImageData(Math.round(c.width * part), c.height / 2, 1, 1).data[3] > 0; return "
                + "[at(0.1), at(0.5), at(0.9)]; })()";
        browser.await(look + "[1]");
        assertThat(browser.value(look)).isEqualTo(List.of(false, true, false));
    }

    @Test
    void infraredChannelsHaveNames() throws IOException {
        open("ev3-infrared", "IR-SEEK", v(-12, 40, 0, -128, 0, -128, 0, -128));
        assertThat(shown(0)).first().isEqualTo("bearing, −25 to 25 = channel 1−12 channel 20 channel 30 channel 40");
        assertThat(shown(0).get(1)).isEqualTo("distance, of 100 = channel 140 channel 2– channel 3– channel 4–");
        open("ev3-infrared", "IR-REMOTE", v(0, 3, 0, 0));
        assertThat(shown(0)).containsExactly(
                "remote = channel 1no button channel 2top right channel 3no button channel 4no button", "top right");
    }

    @Test
    void withoutAKnownModeTheNumbersAreShownAsTheyWereSent() throws IOException {
        open("ev3-color", "", v(5));
        assertThat(shown(0)).containsExactly("as sent = 05.0", "5.0");
    }
}
