package brickless.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;

class FloorTest {
    private static final Rgb BLACK = new Rgb(0, 0, 0);

    private static Region.Filled box(double x, double y, double width, double height) {
        return new Region.Filled(List.of(List.of(new Point2(x, y), new Point2(x + width, y),
                new Point2(x + width, y + height), new Point2(x, y + height))), false);
    }

    private static World world(Optional<Region> table, Paint... paints) {
        return new World("w", -0.5, -0.25, 2, 1, List.of(paints), List.of(), List.of(), List.of(), List.of(), table,
                List.of(), "");
    }

    private static Floor floor(Paint... paints) {
        return new Floor(world(Optional.empty(), paints));
    }

    @Test
    void emptyFloorIsWhiteEverywhere() {
        assertThat(floor().rgbAt(0.3, 0.3)).isEqualTo(0xFFFFFF);
        assertThat(floor().colourAt(99, -99)).isEqualTo(new Rgb(255, 255, 255));
    }

    @Test
    void laterPaintLiesAbove() {
        Floor floor = floor(new Paint("a", box(0, 0, 0.2, 0.2), BLACK, 1),
                new Paint("b", box(0.1, 0, 0.2, 0.2), new Rgb(10, 20, 30), 1));
        assertThat(floor.rgbAt(0.05, 0.1)).isZero();
        assertThat(floor.rgbAt(0.15, 0.1)).isEqualTo(0x0A141E);
        assertThat(floor.rgbAt(-0.05, 0.1)).isEqualTo(0xFFFFFF);
    }

    @Test
    void edgesAreSharpToHalfAMillimetre() {
        Floor floor = floor(new Paint("tape", box(0.1, -1, 0.019, 3), BLACK, 1));
        assertThat(floor.rgbAt(0.0997, 0.3)).isEqualTo(0xFFFFFF);
        assertThat(floor.rgbAt(0.1003, 0.3)).isZero();
        assertThat(floor.rgbAt(0.1187, 0.3)).isZero();
        assertThat(floor.rgbAt(0.1193, 0.3)).isEqualTo(0xFFFFFF);
    }

    @Test
    void transparentPaintMixes() {
        Floor floor = floor(new Paint("half", box(0, 0, 0.5, 0.5), BLACK, 0.5),
                new Paint("quarter", box(0.2, 0, 0.5, 0.5), new Rgb(255, 0, 0), 0.25));
        assertThat(floor.rgbAt(0.1, 0.1)).isEqualTo(0x808080);
        assertThat(floor.colourAt(0.3, 0.1)).as("127.5 x 0.75 + 255 x 0.25").isEqualTo(new Rgb(159, 96, 96));
    }

    @Test
    void outsideTheTableThereIsNoFloor() {
        Floor floor = new Floor(world(Optional.of(box(0, 0, 0.5, 0.5)),
                new Paint("a", box(-1, -1, 3, 3), new Rgb(9, 9, 9), 1)));
        assertThat(floor.rgbAt(0.25, 0.25)).isEqualTo(0x090909);
        assertThat(floor.rgbAt(0.6, 0.25)).isEqualTo(Floor.NO_FLOOR);
        assertThat(floor.rgbAt(50, 50)).isEqualTo(Floor.NO_FLOOR);
        assertThat(floor.colourAt(0.6, 0.25)).isEqualTo(BLACK);
    }

    @Test
    void spotInTheMiddleOfOneColourReadsThatColour() {
        Floor floor = floor(new Paint("a", box(0, 0, 0.5, 0.5), new Rgb(12, 200, 7), 1));
        assertThat(floor.average(0.25, 0.25, 0.005)).isEqualTo(new Rgb(12, 200, 7));
        assertThat(floor.average(0.25, 0.25, 0)).isEqualTo(new Rgb(12, 200, 7));
    }

    @Test
    void spotOnAnEdgeReadsTheShareOfItsPoints() {
        Floor floor = floor(new Paint("a", box(0, -0.2, 0.5, 0.5), BLACK, 1));
        assertThat(floor.average(-0.0003, 0.1, 0.01)).as("11 of 19 points are white").isEqualTo(new Rgb(148, 148, 148));
    }

    @Test
    void floorAgreesWithItsRegionsEverywhere() {
        Random random = new Random(7);
        List<Paint> paints = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            List<Point2> ring = new ArrayList<>();
            for (int k = 0; k < 3 + i; k++) {
                ring.add(new Point2(random.nextDouble() * 2 - 0.5, random.nextDouble() - 0.25));
            }
            Region region = i % 3 == 2 ? new Region.Stroked(List.of(ring), 0.03, i % 2 == 0)
                    : new Region.Filled(List.of(ring), i % 3 == 0);
            paints.add(new Paint("p" + i, region, new Rgb(i * 20, 255 - i * 20, i), 1));
        }
        Floor floor = floor(paints.toArray(Paint[]::new));
        for (int i = 0; i < 4_000; i++) {
            double x = -0.5 + (random.nextInt(4_000) + 0.5) * Floor.SAMPLE_METRES;
            double y = -0.25 + (random.nextInt(2_000) + 0.5) * Floor.SAMPLE_METRES;
            int expected = 0xFFFFFF;
            for (Paint paint : paints) {
                if (paint.region().contains(x, y)) {
                    expected = paint.colour().red() << 16 | paint.colour().green() << 8 | paint.colour().blue();
                }
            }
            assertThat(floor.rgbAt(x, y)).as("point " + i + " at " + x + ", " + y).isEqualTo(expected);
        }
    }

    @Test
    void threadsSeeTheSameFloor() throws Exception {
        Floor shared = floor(new Paint("a", box(0, 0, 0.7, 0.3), new Rgb(1, 2, 3), 0.4),
                new Paint("b", box(0.3, 0.1, 0.7, 0.3), BLACK, 0.3));
        Callable<Long> scan = () -> {
            long sum = 0;
            for (int i = 0; i < 40_000; i++) {
                sum = sum * 31 + shared.rgbAt((i % 200) * 0.007 - 0.4, (i / 200) * 0.004 - 0.2);
            }
            return sum;
        };
        ExecutorService pool = Executors.newFixedThreadPool(2);
        try {
            Future<Long> other = pool.submit(scan);
            Future<Long> third = pool.submit(scan);
            long own = scan.call();
            assertThat(other.get()).isEqualTo(own);
            assertThat(third.get()).isEqualTo(own);
        } finally {
            pool.shutdown();
        }
    }

    @Test
    void imagesAreSampledWithoutSmoothing() {
        Texture texture = new Texture(2, 1, new int[] {0xFFFF0000, 0x000000FF}, 10, 0, 0, 10, 0, 0);
        Floor floor = floor(new Paint("t", box(0, 0, 0.2, 0.1), new Rgb(0, 0, 0), 1, Optional.of(texture)));
        assertThat(floor.rgbAt(0.0999, 0.05)).isEqualTo(0xFF0000);
        assertThat(floor.rgbAt(0.1001, 0.05)).as("transparent pixel").isEqualTo(0xFFFFFF);
    }
}
