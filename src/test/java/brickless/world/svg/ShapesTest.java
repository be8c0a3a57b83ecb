package brickless.world.svg;

import static brickless.world.svg.Drawings.area;
import static brickless.world.svg.Drawings.outline;
import static brickless.world.svg.Drawings.outlines;
import static brickless.world.svg.Drawings.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.world.Point2;
import java.util.List;
import org.junit.jupiter.api.Test;

class ShapesTest {
    private static List<Point2> points(String body) {
        return world(body).obstacles().get(0).outlines().get(0);
    }

    @Test
    void rectangle() {
        assertThat(outline("<rect data-solid='fixed' x='10' y='20' width='30' height='40'/>"))
                .isEqualTo("10,20 40,20 40,60 10,60");
    }

    @Test
    void rectangleMayStateItsUnits() {
        assertThat(outline("<rect data-solid='fixed' x='1cm' y='20mm' width='10%' height='1in'/>"))
                .isEqualTo("10,20 110,20 110,45.4 10,45.4");
    }

    @Test
    void roundedRectangleLosesFourCorners() {
        List<Point2> ring = points("<rect data-solid='fixed' width='200' height='100' rx='20'/>");
        assertThat(ring.get(0)).isEqualTo(new Point2(0.02, 0));
        assertThat(area(ring)).isCloseTo(200 * 100 - (4 - Math.PI) * 400, within(25.0));
    }

    @Test
    void radiusOfARoundedRectangleIsLimitedToHalfItsSides() {
        List<Point2> ring = points("<rect data-solid='fixed' width='100' height='40' rx='500' ry='20'/>");
        assertThat(area(ring)).isCloseTo(Math.PI * 50 * 20, within(40.0));
    }

    @Test
    void circleKeepsItsExtremePointsAndStaysWithinAFifthOfAMillimetre() {
        List<Point2> ring = points("<circle data-solid='fixed' cx='100' cy='200' r='50'/>");
        assertThat(ring).contains(new Point2(0.15, 0.2), new Point2(0.1, 0.25), new Point2(0.05, 0.2),
                new Point2(0.1, 0.15));
        for (int i = 0; i < ring.size(); i++) {
            Point2 a = ring.get(i);
            Point2 b = ring.get((i + 1) % ring.size());
            double middle = Math.hypot((a.x() + b.x()) / 2 - 0.1, (a.y() + b.y()) / 2 - 0.2);
            assertThat(middle).as("edge " + i).isBetween(0.0498, 0.05);
        }
    }

    @Test
    void ellipse() {
        List<Point2> ring = points("<ellipse data-solid='fixed' cx='100' cy='100' rx='80' ry='20'/>");
        assertThat(area(ring)).isCloseTo(Math.PI * 80 * 20, within(50.0));
        assertThat(ring).contains(new Point2(0.18, 0.1), new Point2(0.1, 0.12));
    }

    @Test
    void polygon() {
        assertThat(outline("<polygon data-solid='fixed' points='0,0 30,0,30 40'/>")).isEqualTo("0,0 30,0 30,40");
    }

    @Test
    void filledPolylineIsClosed() {
        assertThat(outline("<polyline data-solid='fixed' points='0,0 30,0 30,40'/>")).isEqualTo("0,0 30,0 30,40");
    }

    @Test
    void outlinesRunClockwiseOnThePageHoweverTheyAreDrawn() {
        assertThat(outline("<polygon data-solid='fixed' points='30,40 30,0 0,0'/>")).isEqualTo("0,0 30,0 30,40");
    }

    @Test
    void pathWithAbsoluteAndRelativeLines() {
        assertThat(outline("<path data-solid='fixed' d='M10 10 h30 v30 l-15,15L10,40z'/>"))
                .isEqualTo("10,10 40,10 40,40 25,55 10,40");
        assertThat(outline("<path data-solid='fixed' d='m10,10 30,0 0,30 H10 V25'/>"))
                .isEqualTo("10,10 40,10 40,40 10,40");
    }

    @Test
    void numbersInPathsNeedNoSeparators() {
        assertThat(outline("<path data-solid='fixed' d='M.5.5L10.5.5 10.5-9.5.5-9.5z'/>"))
                .isEqualTo("0.5,-9.5 10.5,-9.5 10.5,0.5 0.5,0.5");
        assertThat(outline("<path data-solid='fixed' d='M0,0 1e2,0 1E2,5e+1z'/>")).isEqualTo("0,0 100,0 100,50");
    }

    @Test
    void cubicCurveHasTheAreaOfItsFormula() {
        List<Point2> ring = points("<path data-solid='fixed' d='M0,0 C0,60 100,60 100,0 z'/>");
        assertThat(area(ring)).isCloseTo(0.6 * 100 * 60, within(20.0));
    }

    @Test
    void smoothCubicMirrorsTheControlPoint() {
        assertThat(outline("<path data-solid='fixed' d='M0,0 C0,60 100,60 100,0 S200,-60 200,0 L200,100 0,100z'/>"))
                .isEqualTo(outline("<path data-solid='fixed' d='M0,0 C0,60 100,60 100,0 C100,-60 200,-60 200,0 "
                        + "L200,100 0,100z'/>"));
    }

    @Test
    void smoothCubicWithoutACurveBeforeStartsAtThePen() {
        assertThat(outline("<path data-solid='fixed' d='M0,0 S100,60 100,0 z'/>"))
                .isEqualTo(outline("<path data-solid='fixed' d='M0,0 C0,0 100,60 100,0 z'/>"));
    }

    @Test
    void quadraticCurveHasTwoThirdsOfItsBox() {
        List<Point2> ring = points("<path data-solid='fixed' d='M0,0 Q50,80 100,0 z'/>");
        assertThat(area(ring)).isCloseTo(2.0 / 3 * 100 * 40, within(20.0));
    }

    @Test
    void smoothQuadraticMirrorsTheControlPoint() {
        assertThat(outline("<path data-solid='fixed' d='M0,0 Q50,80 100,0 T200,0 L200,200 0,200z'/>"))
                .isEqualTo(outline("<path data-solid='fixed' d='M0,0 Q50,80 100,0 Q150,-80 200,0 L200,200 0,200z'/>"));
    }

    @Test
    void fourArcsOfACircleByTheirFlags() {
        double circle = Math.PI * 2500;
        double small = circle / 4 - 1250;
        assertThat(area(points("<path data-solid='fixed' d='M50,0 A50,50 0 0 1 100,50 z'/>")))
                .isCloseTo(small, within(20.0));
        assertThat(area(points("<path data-solid='fixed' d='M50,0 A50,50 0 0 0 100,50 z'/>")))
                .isCloseTo(small, within(20.0));
        assertThat(area(points("<path data-solid='fixed' d='M50,0 A50,50 0 1 1 100,50 z'/>")))
                .isCloseTo(circle - small, within(40.0));
        assertThat(area(points("<path data-solid='fixed' d='M50,0 A50,50 0 1 0 100,50 z'/>")))
                .isCloseTo(circle - small, within(40.0));
        assertThat(points("<path data-solid='fixed' d='M50,0A50 50 0 0150,100z'/>").stream().mapToDouble(Point2::x)
                .max().orElse(0))
                .isCloseTo(0.1, within(0.0002));
    }

    @Test
    void arcWithTooSmallRadiiGrowsAndRotatedEllipseTurns() {
        assertThat(area(points("<path data-solid='fixed' d='M0,0 A10,10 0 0 1 100,0 z'/>")))
                .isCloseTo(Math.PI * 2500 / 2, within(30.0));
        List<Point2> ring = points("<path data-solid='fixed' d='M50,0 A80,20 90 0 1 50,160 A80,20 90 0 1 50,0z'/>");
        assertThat(ring.stream().mapToDouble(Point2::x).max().orElse(0)).isCloseTo(0.07, within(0.0002));
    }

    @Test
    void twoSubpathsAreTwoBodiesOfOneObstacle() {
        assertThat(outlines("<path data-solid='fixed' d='M0,0h10v10h-10z M20,0h10v10h-10z'/>"))
                .containsExactly("0,0 10,0 10,10 0,10", "20,0 30,0 30,10 20,10");
    }

    @Test
    void relativeMoveAfterCloseStartsFromTheSubpathsStart() {
        assertThat(outlines("<path data-solid='fixed' d='M0,0h10v10h-10z m20,0h10v10h-10z'/>"))
                .containsExactly("0,0 10,0 10,10 0,10", "20,0 30,0 30,10 20,10");
    }

    @Test
    void pointsOnStraightLinesAndRepeatedPointsAreDropped() {
        assertThat(outline("<polygon data-solid='fixed' points='0,0 10,0 20,0 20,0 20,20 0,20 0,10 0,0'/>"))
                .isEqualTo("0,0 20,0 20,20 0,20");
    }
}
