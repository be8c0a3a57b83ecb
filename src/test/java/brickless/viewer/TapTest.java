package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.trace.Sample;
import brickless.trace.TraceEvent;
import brickless.trace.TraceHeader;
import java.util.List;
import org.junit.jupiter.api.Test;

class TapTest {
    private final Tap tap = new Tap();

    TapTest() {
        tap.header(new TraceHeader("Main", "pen", List.of("educator"), 1, -1, false, 2_000_000, 50_000_000));
    }

    private void screen(long millis, String robot, int row, String pixels) {
        tap.event(millis * 1_000_000, robot, new TraceEvent.ScreenEvent(List.of(row), List.of(pixels)));
    }

    @Test
    void eventsComeOnceAndInOrder() {
        tap.event(1_000_000, "robot", new TraceEvent.LedEvent(1));
        tap.event(2_000_000, "robot", new TraceEvent.PrintEvent("hello", false));
        assertThat(tap.takeEvents()).containsExactly("{\"t\":0.001,\"type\":\"led\",\"robot\":\"robot\",\"pattern\":1}",
                "{\"t\":0.002,\"type\":\"print\",\"robot\":\"robot\",\"text\":\"hello\",\"error\":false}");
        assertThat(tap.takeEvents()).isEmpty();
    }

    @Test
    void changesOfOneScreenAreAddedUp() {
        screen(1, "one", 5, "aa");
        screen(2, "two", 5, "bb");
        tap.event(3_000_000, "one", new TraceEvent.LedEvent(1));
        screen(4, "one", 3, "cc");
        screen(5, "one", 5, "dd");
        List<String> lines = tap.takeEvents();
        assertThat(lines).hasSize(3);
        assertThat(lines.get(0)).contains("\"robot\":\"two\"", "\"rows\":[5],\"pixels\":[\"bb\"]");
        assertThat(lines.get(1)).contains("led");
        assertThat(lines.get(2)).contains("\"t\":0.005", "\"robot\":\"one\"",
                "\"rows\":[3,5],\"pixels\":[\"cc\",\"dd\"]");
    }

    @Test
    void onlyTheNewestSampleIsNew() {
        tap.sample(new Sample(0, List.of(), List.of()));
        tap.sample(new Sample(50_000_000, List.of(), List.of()));
        assertThat(tap.takeSample().orElseThrow().timeNanos()).isEqualTo(50_000_000);
        assertThat(tap.takeSample()).isEmpty();
    }

    @Test
    void whatIsSkippedIsStillRecorded() {
        tap.event(1_000_000, "robot", new TraceEvent.PrintEvent("hello", false));
        tap.sample(new Sample(0, List.of(), List.of()));
        tap.skip();
        assertThat(tap.takeEvents()).isEmpty();
        assertThat(tap.takeSample()).isEmpty();
        assertThat(brickless.trace.JsonText.object(line -> tap.recording().write(line))).contains("hello");
    }
}
