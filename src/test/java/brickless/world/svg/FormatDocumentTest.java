package brickless.world.svg;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.world.SensorType;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** {@code sim/docs/WORLD-FORMAT.md} says what is true. */
class FormatDocumentTest {
    private static final Pattern EXAMPLE = Pattern.compile("<!-- (world|robot) -->\n```xml\n(.*?)```", Pattern.DOTALL);

    private static String document() throws IOException {
        return Files.readString(Shipped.file("sim/docs/WORLD-FORMAT.md"));
    }

    @TestFactory
    Stream<DynamicTest> everyExampleCanBeRead() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        Matcher examples = EXAMPLE.matcher(document());
        while (examples.find()) {
            String kind = examples.group(1);
            String svg = examples.group(2);
            tests.add(DynamicTest.dynamicTest(kind + " " + (tests.size() + 1), () -> {
                if (kind.equals("world")) {
                    assertThat(SvgWorldReader.readText("example.svg", svg).floor().size()
                            + SvgWorldReader.readText("example.svg", svg).obstacles().size()).isPositive();
                } else {
                    assertThat(SvgRobotReader.readText("example.svg", svg).sensors()).isNotEmpty();
                }
            }));
        }
        assertThat(tests).hasSize(5);
        return tests.stream();
    }

    @Test
    void everyCodeBlockOfXmlIsAnExample() throws IOException {
        assertThat(document().split("```xml", -1)).hasSize(6);
    }

    @Test
    void groupExampleHasThreeBodies() throws Exception {
        Matcher examples = EXAMPLE.matcher(document());
        assertThat(examples.find() && examples.find()).isTrue();
        assertThat(SvgWorldReader.readText("example.svg", examples.group(2)).obstacles())
                .extracting(one -> one.id() + " " + one.massKilograms())
                .containsExactly("can-1 0.03", "can-2 0.03", "trolley 1.2");
    }

    @Test
    void everyAttributeAndSensorIsDescribed() throws IOException {
        String text = document();
        String complaint = Drawings.worldError(Drawings.worldText("<g data-xxxxxxxx=''/>")) + " "
                + Drawings.robotError(Drawings.robotText("<g data-xxxxxxxx=''/>"));
        Matcher names = Pattern.compile("data-[a-wyz-]+").matcher(complaint);
        while (names.find()) {
            assertThat(text).contains("`" + names.group());
        }
        for (SensorType type : SensorType.values()) {
            assertThat(text).contains("`" + type.attribute() + "`");
        }
    }

    @Test
    void theComplaintShownIsTheComplaintGiven() throws IOException {
        String complaint = Drawings.worldError(
                "<svg viewBox='0 0 9 9'>\n\n\n\n\n\n<rect id='crate' data-solid='moveable' width='9' "
                        + "height='9'/></svg>");
        assertThat(document()).contains(complaint.replace("test.svg", "arena.svg"));
    }
}
