package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.simulation.RunReport;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import brickless.trace.JsonFields;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import programs.robots.KeyWatch;
import programs.robots.TouchWatch;
import programs.robots.TwoPollers;

/** The live view as its viewers see it, over HTTP. */
@Timeout(120)
class LiveViewTest {
    @Test
    void theRunBeginsWithTheFirstViewerAndGoesOnWithoutHim() throws Exception {
        try (Visit visit = Visit.to(TwoPollers.class, 1)) {
            try (Spectator first = Spectator.of(visit.view)) {
                JsonFields begin = first.await("begin").fields();
                assertThat(begin.integer("session")).isEqualTo(1);
                assertThat(begin.text("program")).isEqualTo(TwoPollers.class.getName());
                assertThat(begin.has("limit")).isFalse();
                assertThat(first.await("frame").fields().number("t")).isZero();
                first.awaitTime(0.2);
            }
            try (Spectator second = Spectator.of(visit.view)) {
                assertThat(second.await("frame").fields().number("t")).isGreaterThanOrEqualTo(0.2);
            }
        }
    }

    @Test
    void nobodyTouchesAnythingAndTheTraceIsThatOfAHeadlessRun() throws Exception {
        SimulationSettings settings = Visit.settings().limit(Duration.ofSeconds(3)).build();
        var headless = new Simulation(settings).start(TouchWatch.class);
        headless.toEnd();
        for (double speed : new double[] {2, Speed.MAX}) {
            try (Visit visit = Visit.to(TouchWatch.class, settings, speed);
                    Spectator spectator = Spectator.of(visit.view)) {
                JsonFields ended = spectator.await("state", state -> state.has("ended")).fields();
                assertThat(ended.object("ended").text("hash")).isEqualTo(headless.report().traceHash());
                assertThat(visit.end().traceHash()).isEqualTo(headless.report().traceHash());
            }
        }
    }

    @Test
    void pauseStopsTimeAndStepsLetItGoOnByTheirLength() throws Exception {
        try (Visit visit = Visit.to(TwoPollers.class, 1); Spectator spectator = Spectator.of(visit.view)) {
            spectator.awaitTime(0.05);
            visit.command("{'do':'pause'}");
            double held = spectator.await("state", state -> !state.flag("running")).fields().number("t");
            assertThat(spectator.await("state").fields().number("t")).as("a second later").isEqualTo(held);
            visit.command("{'do':'step'}");
            assertThat(spectator.await("state", state -> state.number("t") != held).fields().number("t"))
                    .isEqualTo(round(held + 0.05));
            visit.command("{'do':'step','millis':2}");
            assertThat(spectator.await("state", state -> state.number("t") > held + 0.051).fields().number("t"))
                    .isEqualTo(round(held + 0.052));
            visit.command("{'do':'play'}");
            spectator.awaitTime(held + 0.2);
        }
    }

    private static double round(double seconds) {
        return Math.round(seconds * 1e6) / 1e6;
    }

    @Test
    void speedIsSimulatedSecondsPerSecond() throws Exception {
        try (Visit visit = Visit.to(TwoPollers.class, 1); Spectator spectator = Spectator.of(visit.view)) {
            assertThat(spectator.await("state").fields().number("speed")).isEqualTo(1);
            visit.command("{'do':'speed','value':'max'}");
            JsonFields fast = spectator.await("state", state -> state.isText("speed") && state.number("rate") > 5)
                    .fields();
            assertThat(fast.text("speed")).isEqualTo("max");
            visit.command("{'do':'speed','value':0.1}");
            assertThat(spectator.await("state", state -> !state.isText("speed")).fields().number("speed"))
                    .isEqualTo(0.1);
            assertThat(spectator.await("state", state -> state.number("rate") < 0.2).fields().number("rate"))
                    .isPositive();
        }
    }

    @Test
    void aKeyThatIsHeldReachesTheProgramAndTheSavedFileRepeatsTheSession() throws Exception {
        try (Visit visit = Visit.to(KeyWatch.class, 1); Spectator spectator = Spectator.of(visit.view)) {
            spectator.awaitTime(0.2);
            visit.command("{'do':'hold','robot':'left','what':'key ENTER','down':true}");
            visit.command("{'do':'hold','robot':'left','what':'key ENTER','down':true}");
            spectator.awaitEvent("\"key\":\"ENTER\",\"down\":true");
            spectator.awaitEvent("\"robot\":\"left\",\"text\":\"2\"");
            visit.command("{'do':'hold','robot':'left','what':'key ENTER','down':false}");
            visit.command("{'do':'hold','robot':'right','what':'key LEFT','down':true}");
            spectator.awaitEvent("\"robot\":\"right\",\"text\":\"16\"");
            visit.command("{'do':'touch','stimulus':'move box 800,300 45'}");
            visit.command("{'do':'touch','stimulus':'press UP 40ms on right'}");
            visit.command("{'do':'touch','stimulus':'move box 810,300 40'}");
            visit.command("{'do':'hold','robot':'right','what':'key LEFT','down':false}");
            spectator.awaitEvent("\"key\":\"LEFT\",\"down\":false");
            visit.command("{'do':'pause'}");
            String stimuli = visit.get("stimuli").body();
            RunReport live = visit.end();
            assertThat(visit.repeat(stimuli, Visit.settings().build()).traceHash()).as(stimuli)
                    .isEqualTo(live.traceHash());
            assertThat(stimuli).contains(" hold key ENTER\n", " release key ENTER\n", " hold key LEFT on right\n",
                    " move box 800,300 45\n");
        }
    }

    @Test
    void viewersSeeTheSameAndOneThatGoesDoesNotDisturb() throws Exception {
        try (Visit visit = Visit.to(TwoPollers.class, 1); Spectator stays = Spectator.of(visit.view)) {
            try (Spectator goes = Spectator.of(visit.view)) {
                assertThat(goes.await("begin").fields().integer("viewer")).isEqualTo(2);
                String frame = goes.await("frame", f -> f.number("t") > 0.1).json();
                assertThat(stays.await("frame", f -> f.number("t") >= JsonFields.parse(frame).number("t")).json())
                        .isEqualTo(frame);
            }
            double now = stays.await("state").fields().number("t");
            stays.awaitTime(now + 0.5);
        }
    }

    @Test
    void framesShowWhatTheSensorsSee() throws Exception {
        try (Visit visit = Visit.to(TwoPollers.class, 1); Spectator spectator = Spectator.of(visit.view)) {
            JsonFields robot = spectator.await("frame", frame -> frame.number("t") > 0.3).fields()
                    .objects("robots").get(0);
            assertThat(robot.text("name")).isEqualTo("left");
            assertThat(robot.number("x")).isBetween(0.0, 2.0);
            List<JsonFields> beams = robot.objects("beams");
            List<JsonFields> spots = robot.objects("spots");
            assertThat(beams.size() + spots.size()).isPositive();
        }
    }
}
