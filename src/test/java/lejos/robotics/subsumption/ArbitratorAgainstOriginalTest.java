package lejos.robotics.subsumption;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import lejos.OriginalJar;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

/** The order of calls is that of the published arbitrator, wherever that one does not depend on luck. */
class ArbitratorAgainstOriginalTest {
    private static final int SCRIPTS = 60;

    @Test
    void randomScriptsRunInTheSameOrder() {
        Assertions.assertTimeoutPreemptively(Duration.ofSeconds(50), () -> {
            for (int seed = 0; seed < SCRIPTS; seed++) {
                List<String> ours = Scripted.play(seed);
                assertEquals(OriginalJar.run(Scripted.class, "play", seed), ours, "script " + seed);
                assertTrue(ours.size() >= 13, "script " + seed + " is too short to mean anything: " + ours);
            }
        });
    }
}
