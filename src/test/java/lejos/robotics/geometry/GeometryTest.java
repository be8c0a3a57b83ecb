package lejos.robotics.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class GeometryTest {
    @Test
    void pointToTheLeftIsCounterclockwiseWithYUp() {
        assertThat(Line2D.relativeCCW(0, 0, 10, 0, 5, 3)).isEqualTo(-1);
        assertThat(Line2D.relativeCCW(0, 0, 10, 0, 5, -3)).isEqualTo(1);
    }

    @Test
    void pointOnTheStraightLineIsBeforeBetweenOrBeyond() {
        assertThat(Line2D.relativeCCW(0, 0, 10, 0, -1, 0)).isEqualTo(-1);
        assertThat(Line2D.relativeCCW(0, 0, 10, 0, 10, 0)).isZero();
        assertThat(Line2D.relativeCCW(0, 0, 10, 0, 11, 0)).isEqualTo(1);
    }

    @Test
    void distanceToASegmentIsToItsEndOrAcross() {
        assertThat(Line2D.ptSegDist(0, 0, 10, 0, 13, 4)).isEqualTo(5);
        assertThat(Line2D.ptSegDist(0, 0, 10, 0, 5, -2)).isEqualTo(2);
    }

    @Test
    void shorteningAVectorKeepsItsDirection() {
        Point shorter = new Point(3, 4).subtract(1);
        assertThat(shorter.x).isCloseTo(2.4f, within(1e-6f));
        assertThat(shorter.y).isCloseTo(3.2f, within(1e-6f));
    }

    @Test
    void pointFromRadiansTurnsClockwise() {
        Point quarter = new Point((float) (Math.PI / 2));
        assertThat(quarter.x).isCloseTo(0, within(1e-6f));
        assertThat(quarter.y).isCloseTo(-1, within(1e-6f));
    }

    @Test
    void crossingLinesMeet() {
        assertThat(new Line(0, 0, 4, 4).intersectsAt(new Line(0, 4, 4, 0))).isEqualTo(new Point(2, 2));
    }

    @Test
    void linesThatEndBeforeTheCrossingDoNotMeet() {
        assertThat(new Line(0, 0, 1, 1).intersectsAt(new Line(0, 4, 4, 0))).isNull();
    }

    @Test
    void parallelLinesDoNotMeetEvenIfTheyOverlap() {
        assertThat(new Line(0, 0, 4, 0).intersectsAt(new Line(1, 0, 6, 0))).isNull();
        assertThat(new Line(0, 0, 4, 2).intersectsAt(new Line(0, 1, 4, 3))).isNull();
    }

    @Test
    void lineThatEndsOnAnotherMeetsItInSpiteOfRounding() {
        for (int i = 1; i < 1000; i++) {
            float x = i * 0.1f;
            Line wall = new Line(0, 0, 100, 33.3f);
            Line probe = new Line(x, -50, x, x * 0.333f);
            assertThat(wall.intersectsAt(probe)).as("index " + i).isNotNull();
        }
    }

    @Test
    void lengtheningMovesBothEnds() {
        Line line = new Line(0, 0, 3, 4);
        line.lengthen(5);
        assertThat(line.getP1().distance(-3, -4)).isLessThan(1e-5);
        assertThat(line.getP2().distance(6, 8)).isLessThan(1e-5);
    }

    @Test
    void lineWithoutLengthGrowsAlongX() {
        Line line = new Line(2, 3, 2, 3);
        line.lengthen(1);
        assertThat(line.getP1()).isEqualTo(new Point(1, 3));
        assertThat(line.getP2()).isEqualTo(new Point(3, 3));
    }

    @Test
    void equalPointsHaveEqualHashCodes() {
        assertThat(new Point(1, -0f)).isEqualTo(new Point2D.Double(1, 0)).hasSameHashCodeAs(new Point2D.Double(1, 0));
        assertThat(new Rectangle(1, 2, 3, 4)).isEqualTo(new RectangleInt32(1, 2, 3, 4))
                .hasSameHashCodeAs(new RectangleInt32(1, 2, 3, 4));
    }

    @Test
    void wholeRectangleDoesNotContainItselfAsInLejos() {
        RectangleInt32 r = new RectangleInt32(0, 0, 10, 10);
        assertThat(r.contains(r)).isFalse();
        assertThat(r.contains((Rectangle2D) r)).isTrue();
    }

    @Test
    void texts() {
        assertThat(new Point(1, 2.5f)).hasToString("Point2D.Float[1.0, 2.5]");
        assertThat(new Point2D.Double(1, 2.5)).hasToString("Point2D.Double[1.0, 2.5]");
        assertThat(new RectangleInt32(10, 20)).hasToString("Rectangle[x=0,y=0,width=10,height=20]");
    }
}
