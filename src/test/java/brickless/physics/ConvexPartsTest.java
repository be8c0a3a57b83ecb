package brickless.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.TestWorlds;
import brickless.world.Point2;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

class ConvexPartsTest {
    private static double area(List<List<Point2>> pieces) {
        return pieces.stream().mapToDouble(ConvexParts::signedArea).sum();
    }

    @Test
    void rectangleStaysWhole() {
        List<List<Point2>> pieces = ConvexParts.of(TestWorlds.box(0, 0, 0.3, 0.1));
        assertThat(pieces).hasSize(1);
        assertThat(pieces.get(0)).hasSize(4);
    }

    @Test
    void orientationDoesNotMatter() {
        List<Point2> reversed = new ArrayList<>(TestWorlds.box(0, 0, 0.3, 0.1));
        Collections.reverse(reversed);
        assertThat(area(ConvexParts.of(reversed))).isCloseTo(0.03, offset(1e-12));
    }

    @Test
    void angleShapeIsCutIntoTwo() {
        List<Point2> angle = List.of(new Point2(0, 0), new Point2(0.3, 0), new Point2(0.3, 0.1), new Point2(0.1, 0.1),
                new Point2(0.1, 0.3),
                new Point2(0, 0.3));
        List<List<Point2>> pieces = ConvexParts.of(angle);
        assertThat(pieces).hasSize(2);
        assertThat(area(pieces)).isCloseTo(0.05, offset(1e-12));
    }

    /** A sliver would push what is a few millimetres inside on through the disc instead of out. */
    @Test
    void discIsCutIntoDeepSlices() {
        List<Point2> disc = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            disc.add(new Point2(0.06 * Math.cos(i * Math.PI / 30), 0.06 * Math.sin(i * Math.PI / 30)));
        }
        List<List<Point2>> pieces = ConvexParts.of(disc);
        assertThat(pieces).hasSize(10);
        assertThat(area(pieces)).isCloseTo(ConvexParts.signedArea(disc), offset(1e-12));
        assertThat(pieces).allSatisfy(piece -> assertThat(piece).anySatisfy(corner ->
                assertThat(Math.hypot(corner.x(), corner.y())).isLessThan(1e-9)));
    }

    @Test
    void outlineWithoutAreaGivesNothing() {
        assertThat(ConvexParts.of(List.of(new Point2(0, 0), new Point2(1, 0), new Point2(2, 0)))).isEmpty();
        assertThat(ConvexParts.of(List.of(new Point2(0, 0), new Point2(0, 0)))).isEmpty();
    }

    /** Stars and rough discs with many corners: pieces are convex, small enough, and together as large as the whole. */
    @Test
    void piecesOfStarsAreConvexAndCoverTheWhole() {
        for (int index = 0; index < 60; index++) {
            int corners = 3 + index % 20;
            double dent = 0.3 + 0.35 * (index / 20);
            List<Point2> star = new ArrayList<>();
            for (int i = 0; i < 2 * corners; i++) {
                double radius = i % 2 == 0 ? 0.5 : 0.5 * dent;
                double angle = Math.PI * i / corners;
                star.add(new Point2(radius * Math.cos(angle), radius * Math.sin(angle)));
            }
            List<List<Point2>> pieces = ConvexParts.of(star);
            assertThat(area(pieces)).as("index %d", index).isCloseTo(ConvexParts.signedArea(star), offset(1e-9));
            for (List<Point2> piece : pieces) {
                assertThat(piece).as("index %d", index).hasSizeBetween(3, ConvexParts.MAX_CORNERS);
                assertThat(leastTurn(piece)).as("index %d", index).isNotNegative();
            }
        }
    }

    private static double leastTurn(List<Point2> ring) {
        double least = Double.POSITIVE_INFINITY;
        int n = ring.size();
        for (int i = 0; i < n; i++) {
            Point2 a = ring.get(i);
            Point2 b = ring.get((i + 1) % n);
            Point2 c = ring.get((i + 2) % n);
            least = Math.min(least, (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x()));
        }
        return least;
    }
}
