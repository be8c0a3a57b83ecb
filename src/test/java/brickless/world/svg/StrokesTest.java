package brickless.world.svg;

import static brickless.world.svg.Drawings.area;
import static brickless.world.svg.Drawings.outline;
import static brickless.world.svg.Drawings.outlines;
import static brickless.world.svg.Drawings.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.Region;
import java.util.List;
import org.junit.jupiter.api.Test;

class StrokesTest {
    private static Region paint(String body) {
        return world("<g fill='none' stroke='black'>" + body + "</g>").floor().get(0).region();
    }

    private static boolean covers(Region region, double xMillimetres, double yMillimetres) {
        return region.contains(xMillimetres / 1000, yMillimetres / 1000);
    }

    @Test
    void lineBecomesARectangleOfItsWidth() {
        assertThat(outline("<line data-solid='fixed' x1='100' y1='50' x2='300' y2='50' stroke='black' "
                + "stroke-width='20'/>"))
                .isEqualTo("100,40 300,40 300,60 100,60");
    }

    @Test
    void frameDrawnAsALineBecomesFourMitredWalls() {
        assertThat(outlines("<rect data-solid='fixed' x='10' y='10' width='80' height='40' fill='none' "
                + "stroke='black' stroke-width='20'/>"))
                .containsExactlyInAnyOrder("0,0 100,0 80,20 20,20", "100,0 100,60 80,40 80,20",
                        "100,60 0,60 20,40 80,40", "0,60 0,0 20,20 20,40");
    }

    @Test
    void wallsOfAnOpenCornerMeetInAMitre() {
        assertThat(outlines("<polyline data-solid='fixed' points='0,0 100,0 100,100' fill='none' stroke='black' "
                + "stroke-width='20'/>"))
                .containsExactlyInAnyOrder("0,-10 110,-10 90,10 0,10", "110,-10 110,100 90,100 90,10");
    }

    @Test
    void bevelledCornerGetsATriangle() {
        assertThat(outlines("<polyline data-solid='fixed' points='0,0 100,0 100,100' fill='none' stroke='black' "
                + "stroke-width='20' stroke-linejoin='bevel'/>"))
                .contains("0,-10 100,-10 100,10 0,10", "100,0 100,-10 110,0");
    }

    @Test
    void veryPointedCornerIsBevelledAtTheMiterLimit() {
        Obstacle pointed = world("<polyline data-solid='fixed' points='0,0 100,0 0,10' fill='none' stroke='black' "
                + "stroke-width='10'/>").obstacles().get(0);
        double reach = pointed.outlines().stream().flatMap(List::stream).mapToDouble(Point2::x).max().orElse(0);
        assertThat(reach).isLessThan(0.106);
        Obstacle mitred = world("<polyline data-solid='fixed' points='0,0 100,0 0,10' fill='none' stroke='black' "
                + "stroke-width='10' stroke-miterlimit='30'/>")
                .obstacles().get(0);
        double tip = mitred.outlines().stream().flatMap(List::stream).mapToDouble(Point2::x).max().orElse(0);
        assertThat(tip).isBetween(0.19, 0.21);
    }

    @Test
    void roundCapsAndJoinsAreDiscs() {
        Region line = paint("<polyline points='100,100 200,100 200,200' stroke-width='20' stroke-linecap='round' "
                + "stroke-linejoin='round'/>");
        assertThat(covers(line, 91, 100)).isTrue();
        assertThat(covers(line, 89, 100)).isFalse();
        assertThat(covers(line, 206, 94)).isTrue();
        assertThat(covers(line, 209, 91)).isFalse();
    }

    @Test
    void buttAndSquareCaps() {
        assertThat(covers(paint("<line x1='100' y1='100' x2='200' y2='100' stroke-width='20'/>"), 99, 100)).isFalse();
        Region square = paint("<line x1='100' y1='100' x2='200' y2='100' stroke-width='20' stroke-linecap='square'/>");
        assertThat(covers(square, 91, 108)).isTrue();
        assertThat(covers(square, 89, 100)).isFalse();
    }

    @Test
    void aPointWithARoundCapIsADot() {
        Region dot = paint("<path d='M100,100 h0' stroke-width='20' stroke-linecap='round'/>");
        assertThat(covers(dot, 100, 109)).isTrue();
        assertThat(covers(dot, 109, 109)).isFalse();
        assertThat(world("<path d='M100,100 h0' stroke='black' stroke-width='20' fill='none'/>").floor()).isEmpty();
    }

    @Test
    void bendOfTapeHasTheAreaOfARing() {
        List<List<Point2>> pieces = world(
                "<path data-solid='fixed' d='M100,0 A100,100 0 0 1 0,100' fill='none' stroke='black' "
                        + "stroke-width='20'/>")
                .obstacles().get(0).outlines();
        double sum = pieces.stream().mapToDouble(Drawings::area).sum();
        assertThat(sum).isCloseTo(Math.PI / 4 * (110 * 110 - 90 * 90), within(12.0));
        assertThat(pieces).allSatisfy(piece -> assertThat(piece).hasSize(4));
        assertThat(area(pieces.get(0))).isPositive();
    }

    @Test
    void dashesLeaveGaps() {
        Region dashes = paint("<line x1='0' y1='100' x2='100' y2='100' stroke-width='10' stroke-dasharray='20 10'/>");
        assertThat(covers(dashes, 10, 100)).isTrue();
        assertThat(covers(dashes, 25, 100)).isFalse();
        assertThat(covers(dashes, 31, 100)).isTrue();
        assertThat(covers(dashes, 55, 100)).isFalse();
        Region shifted = paint("<line x1='0' y1='100' x2='100' y2='100' stroke-width='10' stroke-dasharray='20 10' "
                + "stroke-dashoffset='15'/>");
        assertThat(covers(shifted, 4, 100)).isTrue();
        assertThat(covers(shifted, 6, 100)).isFalse();
        Region odd = paint("<line x1='0' y1='100' x2='100' y2='100' stroke-width='10' stroke-dasharray='10'/>");
        assertThat(covers(odd, 5, 100)).isTrue();
        assertThat(covers(odd, 15, 100)).isFalse();
    }

    @Test
    void dashesGoRoundCorners() {
        Region dashes = paint("<path d='M0,0 H50 V50' stroke-width='4' stroke-dasharray='60 20'/>");
        assertThat(covers(dashes, 50, 9)).isTrue();
        assertThat(covers(dashes, 50, 12)).isFalse();
    }

    @Test
    void unevenScaleWidensTheLineOnOneSideOnly() {
        assertThat(outline("<line data-solid='fixed' x1='0' y1='10' x2='100' y2='10' stroke='black' "
                + "stroke-width='10' transform='scale(1,3)'/>"))
                .isEqualTo("0,15 100,15 100,45 0,45");
        assertThat(outline("<line data-solid='fixed' x1='0' y1='10' x2='100' y2='10' stroke='black' "
                + "stroke-width='10' transform='scale(1,3)'"
                + " vector-effect='non-scaling-stroke'/>")).isEqualTo("0,25 100,25 100,35 0,35");
    }
}
