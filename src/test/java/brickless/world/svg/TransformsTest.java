package brickless.world.svg;

import static brickless.world.svg.Drawings.outline;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TransformsTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "translate(100)                 | 110,20 140,20 140,60 110,60",
        "translate(100,50)              | 110,70 140,70 140,110 110,110",
        "translate(100 50)              | 110,70 140,70 140,110 110,110",
        "scale(2)                       | 20,40 80,40 80,120 20,120",
        "scale(2,0.5)                   | 20,10 80,10 80,30 20,30",
        "rotate(90)                     | -20,10 -20,40 -60,40 -60,10",
        "rotate(180)                    | -10,-20 -40,-20 -40,-60 -10,-60",
        "rotate(-90)                    | 20,-10 20,-40 60,-40 60,-10",
        "rotate(90 10 20)               | 10,20 10,50 -30,50 -30,20",
        "rotate(45)                     | -7.07,21.21 14.14,42.43 -14.14,70.71 -35.36,49.5",
        "skewX(45)                      | 30,20 60,20 100,60 70,60",
        "skewY(45)                      | 10,30 40,60 40,100 10,70",
        "matrix(0 1 -1 0 200 100)       | 180,110 180,140 140,140 140,110",
        "translate(100,0) rotate(90)    | 80,10 80,40 40,40 40,10",
        "rotate(90), translate(100,0)   | -20,110 -20,140 -60,140 -60,110",
        "none                           | 10,20 40,20 40,60 10,60",
    })
    void transformMovesTheRectangle(String transform, String expected) {
        assertThat(outline("<rect data-solid='fixed' x='10' y='20' width='30' height='40' transform='" + transform
                + "'/>")).isEqualTo(expected);
    }

    @Test
    void mirroringKeepsOutlinesClockwise() {
        assertThat(outline("<rect data-solid='fixed' x='10' y='20' width='30' height='40' transform='scale(-1,1)'/>"))
                .isEqualTo("-10,60 -40,60 -40,20 -10,20");
    }

    @Test
    void groupsApplyFromTheOutside() {
        assertThat(outline("<g transform='translate(100,0)'><g transform='rotate(90)'>"
                + "<rect data-solid='fixed' x='10' y='20' width='30' height='40'/></g></g>"))
                        .isEqualTo("80,10 80,40 40,40 40,10");
    }

    @Test
    void innerViewportFitsItsViewBox() {
        assertThat(outline("<svg x='100' y='100' width='200' height='100' viewBox='0 0 10 10'><rect "
                + "data-solid='fixed' width='10' height='10'/></svg>"))
                .isEqualTo("150,100 250,100 250,200 150,200");
        assertThat(outline("<svg x='100' y='100' width='200' height='100' viewBox='0 0 10 10' "
                + "preserveAspectRatio='none'>"
                + "<rect data-solid='fixed' width='10' height='10'/></svg>"))
                        .isEqualTo("100,100 300,100 300,200 100,200");
        assertThat(outline("<svg width='200' height='100' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMin slice'>"
                + "<rect data-solid='fixed' width='10' height='10'/></svg>")).isEqualTo("0,0 200,0 200,200 0,200");
    }

    @Test
    void usePlacesACopy() {
        assertThat(outline("<defs><rect id='r' width='10' height='20'/></defs><use href='#r' x='100' y='50' "
                + "data-solid='fixed'/>"))
                .isEqualTo("100,50 110,50 110,70 100,70");
        assertThat(outline("<defs><rect id='r' width='10' height='20'/></defs><use "
                + "xmlns:xlink='http://www.w3.org/1999/xlink' xlink:href='#r'"
                + " transform='rotate(90)' x='100' data-solid='fixed'/>")).isEqualTo("0,100 0,110 -20,110 -20,100");
    }

    @Test
    void useOfAUseAndOfASymbol() {
        assertThat(outline("<defs><rect id='r' width='10' height='10'/><use id='u' href='#r' x='5'/></defs><use "
                + "href='#u' y='7' data-solid='fixed'/>"))
                .isEqualTo("5,7 15,7 15,17 5,17");
        assertThat(outline("<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol>"
                + "<use href='#s' x='100' width='50' height='50' data-solid='fixed'/>"))
                        .isEqualTo("100,0 150,0 150,50 100,50");
    }
}
