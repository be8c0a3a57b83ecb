package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import brickless.simulation.Run;
import java.util.List;
import kit.Contacts;
import kit.EV3Sensors;
import kit.OlderSensors;
import kit.Turning;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whole programs that read sensors in a room of known size: exact when ideal, within known bounds when not. */
class SensorRunsTest {
    private static final String NEAR = Kit.world("<rect x='1020' y='980' width='40' height='40' fill='red'/>"
            + "<rect id='wall' data-solid='fixed' x='1340' y='500' width='20' height='1000' fill='white'/>"
            + "<circle id='beacon' data-beacon='1' cx='1300' cy='1000' r='5'/>");
    private static Printed exact;
    private static Printed noisy;
    private static Printed olderExact;
    private static Printed olderNoisy;

    private static Printed run(Class<?> program, String world, String robot, boolean ideal, long seed) {
        try (Run run = Kit.run(program, world, robot, settings -> Kit.stimuli("0s remote 2 TOP_LEFT 60s")
                .apply(settings)
                .ideal(ideal).seed(seed))) {
            assertThat(run.outcome().kind()).isEqualTo("exited");
            return Kit.printed(run);
        }
    }

    @BeforeAll
    static void runAll() {
        exact = run(EV3Sensors.class, Worlds.ROOM, Worlds.EV3, true, 1);
        noisy = run(EV3Sensors.class, Worlds.ROOM, Worlds.EV3, false, 1);
        olderExact = run(OlderSensors.class, NEAR, Worlds.OLDER, true, 1);
        olderNoisy = run(OlderSensors.class, NEAR, Worlds.OLDER, false, 1);
    }

    @Test
    void idealUltrasonicIsExactInMetres() {
        assertThat(exact.words("distance")).containsExactly("0.5");
        assertThat(exact.words("again")).containsExactly("0.5");
        assertThat(exact.words("listen")).containsExactly("0.0");
        assertThat(exact.spread("distances")).isZero();
    }

    @Test
    void aFetchEnablesADisabledUltrasonic() {
        assertThat(exact.words("disabled")).containsExactly("false");
        assertThat(exact.words("enabled")).containsExactly("true");
    }

    @Test
    void idealColourSensorSeesRedPaint() {
        assertThat(exact.words("colorId")).containsExactly("0.0");
        assertThat(exact.words("red")).containsExactly("0.78");
        double[] rgb = exact.numbers("rgb");
        assertThat(rgb[0]).isCloseTo(285.0 / 1020, offset(1.0 / 1020));
        assertThat(rgb[1]).isLessThan(0.04);
        assertThat(rgb[2]).isLessThan(0.04);
        assertThat(exact.number("ambient")).isBetween(0.0, 0.1);
        assertThat(exact.words("lampAtStart")).containsExactly("true");
        assertThat(exact.words("lampOff")).containsExactly("false");
    }

    @Test
    void zeroOfTheGyroIsNegative() {
        assertThat(exact.words("angle")).containsExactly("-0.0");
        assertThat(exact.words("both")).containsExactly("-0.0", "-0.0");
    }

    @Test
    void touchIsZeroWhenFree() {
        assertThat(exact.words("touch")).containsExactly("0.0");
    }

    @Test
    void ultrasonicNoiseStaysWithinACentimetre() {
        assertThat(noisy.list("distances")).allSatisfy(metres -> assertThat(metres).isCloseTo(0.5, offset(0.01)));
        assertThat(noisy.spread("distances")).isGreaterThan(0.003);
    }

    @Test
    void newDistancesComeEvery25Milliseconds() {
        double[] updates = noisy.numbers("distanceUpdates");
        assertThat(updates[0]).as("reads in a second").isBetween(4500.0, 5000.0);
        assertThat(updates[1]).as("changes").isBetween(30.0, 41.0);
        assertThat(updates[2]).as("shortest time between changes").isGreaterThanOrEqualTo(24);
    }

    @Test
    void reflectionAndRateAreQuantisedAndHaveLittleNoise() {
        assertThat(noisy.list("reds")).allSatisfy(share -> {
            assertThat(share).isCloseTo(0.78, offset(0.03));
            assertThat(share * 100).isCloseTo(Math.rint(share * 100), offset(1e-4));
        });
        assertThat(noisy.list("rates")).allSatisfy(rate -> {
            assertThat(Math.abs(rate)).isLessThanOrEqualTo(2);
            assertThat(rate).isEqualTo(Math.rint(rate));
        });
    }

    @Test
    void startsAndModeSwitchesBlock() {
        assertThat(noisy.number("ultrasonicStart")).isBetween(100.0, 103.0);
        assertThat(noisy.number("ultrasonicSwitch")).isBetween(50.0, 53.0);
        assertThat(noisy.number("colourSwitch")).isBetween(20.0, 23.0);
        assertThat(noisy.number("gyroReset")).isBetween(40.0, 46.0);
        assertThat(noisy.number("touchStart")).isBetween(3.0, 5.0);
    }

    @Test
    void idealSensorsMakeNobodyWait() {
        for (String name : List.of("ultrasonicStart", "ultrasonicSwitch", "colourSwitch", "gyroReset", "touchStart")) {
            assertThat(exact.number(name)).as(name).isLessThanOrEqualTo(2);
        }
    }

    @Test
    void theSameSeedGivesTheSameValuesAndAnotherGivesOthers() {
        assertThat(run(EV3Sensors.class, Worlds.ROOM, Worlds.EV3, false, 1)).isEqualTo(noisy);
        Printed other = run(EV3Sensors.class, Worlds.ROOM, Worlds.EV3, false, 2);
        for (String name : List.of("distances", "reds", "rates")) {
            assertThat(other.words(name)).as(name).isNotEqualTo(noisy.words(name));
        }
    }

    @Test
    void idealInfraredSensorTellsPercentOf70Centimetres() {
        assertThat(olderExact.words("proximity")).containsExactly("40.0");
        assertThat(olderExact.words("seek")).containsExactly("0.0", "12.0", "0.0", "Infinity", "0.0", "Infinity",
                "0.0", "Infinity");
        assertThat(olderExact.words("remote")).containsExactly("0", "1");
    }

    @Test
    void idealNxtSensorsSeeRedPaint() {
        assertThat(olderExact.number("lightRed")).isCloseTo(0.524, offset(0.005));
        assertThat(olderExact.number("lightAmbient")).isBetween(0.0, 0.2);
        assertThat(olderExact.words("nxtColorId")).containsExactly("0.0");
        double[] rgb = olderExact.numbers("nxtRgb");
        assertThat(rgb).hasSize(4);
        assertThat(rgb[0]).isCloseTo(2.3 / 3.3, offset(0.002));
        assertThat(rgb[1]).isLessThan(0.2);
    }

    @Test
    void theNxtColourSensorIsCalibratedForASecondOnce() {
        assertThat(olderNoisy.number("nxtColourStart")).isBetween(1000.0, 1050.0);
    }

    @Test
    void idealNxtUltrasonicTellsWholeCentimetres() {
        assertThat(olderExact.words("centimetres")).containsExactly("0.28");
        assertThat(olderExact.words("ping").subList(0, 2)).containsExactly("0.28", "Infinity");
        assertThat(olderExact.words("product")).containsExactly("LEGO", "Sonar", "V1.0");
        assertThat(olderExact.words("afterPing")).containsExactly("false");
    }

    @Test
    void nxtUltrasonicIsAskedEvery30MillisecondsAtMost() {
        assertThat(olderNoisy.number("nxtFetches")).isGreaterThanOrEqualTo(10 * 30);
        assertThat(olderNoisy.number("nxtFetches")).isLessThan(11 * 40);
    }

    @Test
    void olderSensorsAreNoisyWithinBounds() {
        assertThat(olderNoisy.list("nxtDistances")).allSatisfy(m -> assertThat(m).isCloseTo(0.28, offset(0.021)));
        assertThat(olderNoisy.list("lights")).allSatisfy(share -> assertThat(share).isCloseTo(0.524, offset(0.02)));
        assertThat(olderNoisy.spread("lights")).isPositive();
        assertThat(olderNoisy.list("proximities")).allSatisfy(p -> assertThat(p).isCloseTo(40, offset(3.0)));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void leftTurnsArePositive(boolean ideal) {
        try (Run run = Kit.run(Turning.class, Kit.EMPTY, Worlds.EV3, settings -> settings.ideal(ideal))) {
            Printed lines = Kit.printed(run);
            double left = -run.robot().headingDegrees();
            assertThat(left).isBetween(80.0, 95.0);
            assertThat(lines.numbers("turned")[0]).isCloseTo(left, offset(ideal ? 0.51 : 3.0));
            assertThat(lines.numbers("turning")[1]).isBetween(100.0, 200.0);
        }
    }

    @Test
    void handsWallsAndClapsAreFelt() {
        String robot = Kit.robot(Worlds.sensor("S1", "ev3-touch", 60, 20, 30) + Worlds.sensor("S2", "nxt-touch", -110,
                0, 30)
                + Worlds.sensor("S3", "nxt-sound", 0, 0, 60));
        try (Run run = Kit.run(Contacts.class, NEAR, robot, settings -> Kit.stimuli("1s push S1 300ms",
                "2s push S2 300ms",
                "3s clap 85dB").apply(settings).ideal(true))) {
            assertThat(run.outcome().kind()).isEqualTo("exited");
            Printed lines = Kit.printed(run);
            assertThat(lines.words("free")).containsExactly("0.0", "0.0");
            assertThat(lines.number("quiet")).isBetween(0.1, 0.3);
            assertThat(lines.number("hand")).isBetween(1000.0, 1015.0);
            assertThat(lines.number("handOnTheOther")).isBetween(2000.0, 2015.0);
            assertThat(lines.number("clap")).isBetween(3000.0, 3030.0);
            assertThat(lines.number("wall")).as("270 mm at 176 mm/s").isCloseTo(3000 + 1000 * 270 / 175.9,
                    offset(250.0));
            assertThat(lines.words("backedUp")).containsExactly("0.0");
            assertThat(run.robot().xMetres()).isLessThan(1.27);
        }
    }
}
