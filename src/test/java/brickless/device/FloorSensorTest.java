package brickless.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.TestWorlds;
import brickless.device.sensor.FloorColour;
import brickless.world.Lamp;
import brickless.world.Paint;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.Region;
import brickless.world.Rgb;
import brickless.world.SensorType;
import brickless.world.Texture;
import brickless.world.World;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Colour and light sensors on painted floors. */
class FloorSensorTest {
    private static final int WHITE = 0xffffff;
    private static final int BLACK = 0x101010;
    private static final int REFLECT = 0;
    private static final int AMBIENT = 1;
    private static final int COLOUR = 2;
    private static final int RGB = 4;

    private static SensorBench colour(int rgb, int mode) {
        SensorBench sensor = SensorBench.onPaint(SensorType.EV3_COLOR, SensorBench.everywhere(rgb));
        assertThat(sensor.port.uart().initialise(mode)).isTrue();
        return sensor;
    }

    @ParameterizedTest(name = "{1} is {2}")
    @CsvSource({"1,black,101010", "1,black,000000", "1,black,333333", "2,blue,0000ff", "2,blue,0055bf",
            "2,blue,00008b", "3,green,00ff00", "3,green,00852b",
        "3,green,228b22", "4,yellow,ffff00", "4,yellow,f5cd2f", "4,yellow,ffd700", "5,red,ff0000", "5,red,c91a09",
                "5,red,8b0000", "6,white,ffffff",
        "6,white,f5f5dc", "6,white,d3d3d3", "7,brown,8b4513", "7,brown,654321", "7,brown,a0522d"})
    void paintIsNamed(int id, String name, String rgb) {
        assertThat(colour(Integer.parseInt(rgb, 16), COLOUR).bytes(1)[0]).as(name).isEqualTo((byte) id);
    }

    @Test
    void whitePaperReflectsMuchAndBlackTapeLittle() {
        assertThat((int) colour(WHITE, REFLECT).bytes(1)[0]).isBetween(60, 90);
        assertThat((int) colour(BLACK, REFLECT).bytes(1)[0]).isBetween(3, 10);
    }

    @Test
    void redLightIsReflectedByRedAndSwallowedByGreen() {
        assertThat((int) colour(0xff0000, REFLECT).bytes(1)[0]).isGreaterThan(60);
        assertThat((int) colour(0x00a000, REFLECT).bytes(1)[0]).isLessThan(15);
    }

    @Test
    void rawColoursOfPaperAndTapeAreAsUsersReport() {
        int[] white = colour(WHITE, RGB).shorts(3);
        assertThat(Arrays.stream(white).boxed())
                .allSatisfy(raw -> assertThat(raw / 1020.0).isBetween(0.2, 0.35));
        assertThat(white[1]).isGreaterThan(white[0]);
        assertThat(white[0]).isGreaterThan(white[2]);
        assertThat(Arrays.stream(colour(BLACK, RGB).shorts(3)).boxed())
                .allSatisfy(raw -> assertThat(raw / 1020.0).isBetween(0.015, 0.04));
    }

    @Test
    void edgeOfALineReadsInBetween() {
        SensorBench sensor = SensorBench.onPaint(SensorType.EV3_COLOR, SensorBench.everywhere(WHITE),
                SensorBench.paint(BLACK, -1, 0, 1, 1));
        sensor.port.uart().initialise(REFLECT);
        assertThat((int) sensor.bytes(1)[0]).isBetween(30, 52);
    }

    /**
     * The spot is 1 cm wide at a height of 8 mm: that far apart are pure white and pure black around an edge of tape.
     */
    @Test
    void spotIsACentimetreWide() {
        SensorBench sensor = SensorBench.onPaint(SensorType.EV3_COLOR, SensorBench.everywhere(WHITE),
                SensorBench.paint(0, 0.06, -1, 1, 1));
        sensor.port.uart().initialise(REFLECT);
        int between = 0;
        int before = 100;
        for (int step = -100; step <= 100; step++) {
            sensor.bench.arena.move(sensor.bench.robot, new Pose2(0.0001 * step, 0, 0));
            int percent = sensor.bytes(1)[0];
            assertThat(percent).as("%d tenths of a millimetre", step).isLessThanOrEqualTo(before).isBetween(5, 78);
            between += percent > 5 && percent < 78 ? 1 : 0;
            before = percent;
        }
        assertThat(between / 10.0).as("millimetres").isBetween(8.0, 10.5);
    }

    @Test
    void rawColoursStayWithinTheirRange() {
        assertThat(Arrays.stream(colour(0xffffff, RGB).shorts(3)).boxed())
                .allSatisfy(raw -> assertThat(raw).isBetween(0, 1020));
        int[] reflected = colour(0xffffff, 3).shorts(2);
        assertThat(reflected[0]).isBetween(0, reflected[1]);
        assertThat(reflected[1]).isEqualTo(1020);
    }

    @Test
    void higherSensorSeesLess() {
        SensorBench high = new SensorBench(TestWorlds.world(List.of(), List.of(SensorBench.everywhere(WHITE))),
                SensorBench.front(SensorType.EV3_COLOR, 0.03), true);
        high.port.uart().initialise(REFLECT);
        assertThat((int) high.bytes(1)[0]).isBetween(10, 40);
    }

    @Test
    void overTheEdgeThereIsNoColour() {
        World world = new World("table", -1, -1, 2, 2, List.of(SensorBench.everywhere(WHITE)), List.of(), List.of(),
                List.of(), List.of(),
                Optional.of(new Region.Filled(List.of(TestWorlds.box(-0.5, -0.5, 0.04, 0.5)), false)), List.of(), "");
        SensorBench sensor = new SensorBench(world, SensorBench.front(SensorType.EV3_COLOR, 0.008), true);
        sensor.port.uart().initialise(COLOUR);
        assertThat(sensor.bytes(1)[0]).isZero();
        sensor.port.uart().setMode(REFLECT);
        assertThat((int) sensor.bytes(1)[0]).isLessThan(8);
    }

    @Test
    void lampsRaiseTheAmbientLight() {
        int dark = colour(WHITE, AMBIENT).bytes(1)[0];
        World lit = new World("lit", -2, -2, 4, 4, List.of(SensorBench.everywhere(WHITE)), List.of(), List.of(),
                List.of(),
                List.of(new Lamp("lamp", 3000, new Point2(0.06, 0))), Optional.empty(), List.of(), "");
        SensorBench sensor = new SensorBench(lit, SensorBench.front(SensorType.EV3_COLOR, 0.008), true);
        sensor.port.uart().initialise(AMBIENT);
        assertThat(dark).isBetween(1, 15);
        assertThat((int) sensor.bytes(1)[0]).isGreaterThan(50);
    }

    private static SensorBench inLight(SensorType type, double ambientLux, Lamp... lamps) {
        World world = new World("lit", -2, -2, 4, 4, List.of(SensorBench.everywhere(WHITE)), List.of(), List.of(),
                List.of(), List.of(lamps), Optional.empty(), List.of(), "", ambientLux);
        return new SensorBench(world, SensorBench.front(type, 0.008), true);
    }

    /** The documented curve: percent = 100 lux / (lux + 1500), a lamp 0.5 m high at 0.5 m fades to a quarter. */
    @ParameterizedTest(name = "{0} lux and a lamp of {1} at {2} m")
    @CsvSource({"0,0,0,0", "100,0,0,6", "500,0,0,25", "1500,0,0,50", "6000,0,0,80", "0,1500,0,50", "0,6000,0.5,50",
        "750,3000,0.5,50"})
    void ambientLightIsThatOfTheRoomAndTheLamps(double room, double lamp, double away, int percent) {
        SensorBench sensor = inLight(SensorType.EV3_COLOR, room, new Lamp("lamp", lamp, new Point2(0.06, away)));
        sensor.port.uart().initialise(AMBIENT);
        assertThat((int) sensor.bytes(1)[0]).isEqualTo(percent);
    }

    @Test
    void nxtLightSensorWithoutItsLampSeesTheRoom() {
        assertThat(nxtLight(0)).isCloseTo(0.10, offset(0.003));
        assertThat(nxtLight(1000)).isCloseTo(0.55, offset(0.003));
    }

    private static double nxtLight(double lux) {
        SensorBench sensor = inLight(SensorType.NXT_LIGHT, lux);
        sensor.port.analog().setType(6);
        return 1 - sensor.port.analog().pin1Volts() / 5;
    }

    @Test
    void halfTransparentPaintMixesWithWhatLiesBelow() {
        Paint veil = new Paint("veil", SensorBench.everywhere(0).region(), new Rgb(0, 0, 0), 0.5);
        World world = TestWorlds.world(List.of(), List.of(SensorBench.everywhere(WHITE), veil));
        assertThat(FloorColour.of(world).at(0.1, 0.1)).isEqualTo(0x808080);
    }

    @Test
    void imageOnTheFloorIsReadPixelByPixel() {
        Texture pixels = new Texture(2, 1, new int[] {0xffff0000, 0x000000ff}, 10, 0, 0, 10, 0, 0);
        Region region = new Region.Filled(List.of(TestWorlds.box(0, 0, 0.2, 0.1)), false);
        Paint image = new Paint("image", region, new Rgb(0, 0, 0), 1, Optional.of(pixels));
        FloorColour floor = FloorColour.of(TestWorlds.world(List.of(), List.of(image)));
        assertThat(floor.at(0.05, 0.05)).isEqualTo(0xff0000);
        assertThat(floor.at(0.15, 0.05)).as("transparent pixel").isEqualTo(WHITE);
        assertThat(floor.at(-5, -5)).as("beyond the drawing").isEqualTo(WHITE);
    }

    @Test
    void noiseIsSmallAndRepeatable() {
        int[] first = noisyReflections();
        assertThat(first).isEqualTo(noisyReflections());
        assertThat(Arrays.stream(first).boxed()).allSatisfy(value -> assertThat(value).isBetween(74, 82));
        assertThat(Arrays.stream(first).distinct().count()).isGreaterThan(1);
    }

    private static int[] noisyReflections() {
        SensorBench sensor = new SensorBench(TestWorlds.world(List.of(), List.of(SensorBench.everywhere(WHITE))),
                SensorBench.front(SensorType.EV3_COLOR, 0.008), false);
        sensor.port.uart().initialise(REFLECT);
        int[] values = new int[200];
        for (int i = 0; i < values.length; i++) {
            values[i] = sensor.bytes(1)[0];
            sensor.bench.runMillis(1);
        }
        return values;
    }

    @Test
    void nxtLightSensorFollowsItsLamp() {
        SensorBench sensor = SensorBench.onPaint(SensorType.NXT_LIGHT, SensorBench.everywhere(WHITE));
        sensor.port.analog().setType(5);
        double lit = 1 - sensor.port.analog().pin1Volts() / 5;
        sensor.port.analog().setType(6);
        double dark = 1 - sensor.port.analog().pin1Volts() / 5;
        assertThat(lit).isCloseTo(0.62, offset(0.02));
        assertThat(dark).isLessThan(0.3);
    }

    @Test
    void nxtColourSensorTellsVoltagesAndAColour() {
        SensorBench sensor = SensorBench.onPaint(SensorType.NXT_COLOR, SensorBench.everywhere(0xff0000));
        assertThat(sensor.port.analog().setType(13)).isTrue();
        float[] volts = sensor.port.analog().colourVolts();
        assertThat(volts).hasSize(5);
        assertThat(volts[0]).isGreaterThan(2 * volts[1]);
        assertThat(volts[4]).isEqualTo(5);
    }

    @Test
    void nxtSoundSensorHearsAClap() {
        SensorBench sensor = SensorBench.of(SensorType.NXT_SOUND);
        double quiet = sensor.port.analog().pin1Volts();
        sensor.bench.devices.soundLevel(85);
        assertThat(sensor.port.analog().pin1Volts()).isLessThan(quiet - 2);
        sensor.bench.devices.soundLevel(0);
        assertThat(sensor.port.analog().pin1Volts()).isEqualTo(quiet);
    }
}
