package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.browser.Browser;
import brickless.trace.RobotSample.MotorSample;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.svg.SvgRobotReader;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * In the report jaws close and turrets turn with their motors: made-up runs of library robots whose motor A turns 9
 * degrees a second.
 */
@Tag("browser")
class MovingPartsTest {
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

    private static void open(String robot, int second) throws Exception {
        Path page = folder.resolve(robot + ".html");
        if (!Files.exists(page)) {
            RobotModel model = SvgRobotReader.read(
                    Path.of(System.getProperty("brickless.home"), "sim", "robots", robot + ".svg"));
            ReportRecording recording = new ReportRecording();
            recording.header(new TraceHeader("demo.Moving", "hall", List.of(robot), 1, -1, false, 2_000_000,
                    1_000_000_000));
            for (int i = 0; i <= 10; i++) {
                recording.sample(new Sample(i * 1_000_000_000L, List.of(new RobotSample("robot", new Pose2(1, 0.5, 0),
                        List.of(new MotorSample('A', 9 * i, 9, 20, 0.1)), List.of(), 8)), List.of()));
            }
            try (OutputStream out = Files.newOutputStream(page)) {
                HtmlReport.write(out, recording, new ReportScene(SyntheticRun.scene().world(), Map.of("robot", model)),
                        Optional.empty());
            }
        }
        browser.open(page, "#t=" + second);
    }

    /** Where the part of a robot's drawing is on the page: its box in CSS pixels. */
    private static double[] box(String selector) {
        String box = "document.querySelector('.layer.robot').shadowRoot.querySelector('" + selector
                + "').getBoundingClientRect()";
        return List.of("left", "top", "right", "bottom").stream()
                .mapToDouble(side -> ((Number) browser.value("1 * " + box + "." + side)).doubleValue()).toArray();
    }

    @Test
    void jawsClose() throws Exception {
        open("gripper", 0);
        double[] openLeft = box("#claw polygon:nth-of-type(1)");
        double[] openRight = box("#claw polygon:nth-of-type(2)");
        double[] bar = box("#claw rect");
        open("gripper", 10);
        double[] left = box("#claw polygon:nth-of-type(1)");
        double[] right = box("#claw polygon:nth-of-type(2)");
        assertThat(left[3]).as("tip of the left jaw").isGreaterThan(openLeft[3] + 1);
        assertThat(right[1]).as("tip of the right jaw").isLessThan(openRight[1] - 1);
        assertThat(left[3] - openLeft[3]).as("both alike").isCloseTo(openRight[1] - right[1], within(0.2));
        assertThat(left[3]).as("they do not cross").isLessThan(right[1]);
        assertThat(box("#claw rect")).as("the bar stays").containsExactly(bar, within(0.01));
    }

    @Test
    void turretTurnsToTheLeft() throws Exception {
        open("medium-turret", 0);
        double[] ahead = box("#infrared");
        open("medium-turret", 10);
        double[] left = box("#infrared");
        assertThat(left[1]).as("up the page").isLessThan(ahead[1] - 1);
        assertThat(left[2]).as("no longer ahead").isLessThan(ahead[2] - 1);
    }
}
