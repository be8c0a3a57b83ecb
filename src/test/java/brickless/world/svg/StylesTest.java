package brickless.world.svg;

import static brickless.world.svg.Drawings.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.world.Paint;
import brickless.world.Rgb;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StylesTest {
    private static List<Paint> floor(String body) {
        return world(body).floor();
    }

    private static String colour(String body) {
        Rgb rgb = floor(body).get(0).colour();
        return rgb.red() + " " + rgb.green() + " " + rgb.blue();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "red                      | 255 0 0",
        "RebeccaPurple            | 102 51 153",
        "lightgoldenrodyellow     | 250 250 210",
        "#f80                     | 255 136 0",
        "#Ff8001                  | 255 128 1",
        "rgb(1, 2,3)              | 1 2 3",
        "rgb(10 20 30)            | 10 20 30",
        "rgb(100%,50%,0%)         | 255 128 0",
        "rgb(300,-5,0)            | 255 0 0",
        "hsl(0,100%,50%)          | 255 0 0",
        "hsl(120deg 100% 25%)     | 0 128 0",
        "hsl(240, 50%, 50%)       | 64 64 191",
        "hsl(-60, 100%, 50%)      | 255 0 255",
    })
    void colourNotations(String text, String expected) {
        assertThat(colour("<rect width='9' height='9' fill='" + text + "'/>")).isEqualTo(expected);
    }

    @Test
    void everyColourNameOfTheTableIsThere() {
        assertThat(NamedColours.names()).hasSize(148);
    }

    @Test
    void withoutAFillShapesAreBlackAsSvgSays() {
        assertThat(colour("<rect width='9' height='9'/>")).isEqualTo("0 0 0");
    }

    @Test
    void fillIsInheritedAndCurrentColorResolves() {
        assertThat(colour("<g fill='blue'><g><rect width='9' height='9'/></g></g>")).isEqualTo("0 0 255");
        assertThat(colour("<g color='lime'><rect fill='currentColor' width='9' height='9'/></g>")).isEqualTo("0 255 0");
        assertThat(colour("<g fill='blue'><rect fill='inherit' width='9' height='9'/></g>")).isEqualTo("0 0 255");
    }

    @Test
    void styleAttributeBeatsStyleSheetBeatsPresentationAttribute() {
        String sheet = "<style>rect { fill: red } .b { fill: green !important; } #c { fill: blue }</style>";
        assertThat(colour(sheet + "<rect fill='white' width='9' height='9'/>")).isEqualTo("255 0 0");
        assertThat(colour(sheet + "<rect class='x b' fill='white' width='9' height='9'/>")).isEqualTo("0 128 0");
        assertThat(colour(sheet + "<rect id='c' class='b' width='9' height='9'/>")).isEqualTo("0 0 255");
        assertThat(colour(sheet + "<rect id='c' style='fill:#123456;stroke:none' width='9' height='9'/>"))
                .isEqualTo("18 52 86");
    }

    @Test
    void selectorsMayBeCombinedListedAndCommented() {
        String sheet = "<style><![CDATA[ /* tape */ circle.a, rect.a.b { fill: navy } * { fill-opacity: 0.5 } @media "
                + "print { rect { fill: red } }"
                + " @import url('x.css'); rect:hover { fill: red } ]]></style>";
        assertThat(colour(sheet + "<rect class='b a' width='9' height='9'/>")).isEqualTo("0 0 128");
        assertThat(colour(sheet + "<rect class='a' width='9' height='9'/>")).isEqualTo("0 0 0");
        assertThat(floor(sheet + "<rect class='a' width='9' height='9'/>").get(0).opacity()).isEqualTo(0.5);
    }

    @Test
    void opacitiesMultiply() {
        assertThat(floor("<g opacity='0.5'><g opacity='50%'><rect fill='red' fill-opacity='.8' width='9' "
                + "height='9'/></g></g>").get(0).opacity())
                .isCloseTo(0.2, within(1e-12));
        assertThat(floor("<rect fill='rgba(1,2,3,0.25)' width='9' height='9'/>").get(0).opacity()).isEqualTo(0.25);
        assertThat(floor("<rect fill='#01020380' width='9' height='9'/>").get(0).opacity())
                .isCloseTo(128 / 255.0, within(1e-12));
        assertThat(floor("<rect fill='transparent' width='9' height='9'/><rect fill='none' width='9' height='9'/>"))
                .isEmpty();
    }

    @Test
    void fillLiesBelowTheLine() {
        List<Paint> paints = floor("<rect fill='red' stroke='blue' stroke-width='2' width='9' height='9'/>");
        assertThat(paints).extracting(Paint::colour).containsExactly(new Rgb(255, 0, 0), new Rgb(0, 0, 255));
    }

    @Test
    void fillRuleDecidesAboutHoles() {
        String star = "<path d='M0,0h90v90h-90z M30,30h30v30h-30z' fill-rule='%s'/>";
        assertThat(floor(star.formatted("evenodd")).get(0).region().contains(0.045, 0.045)).isFalse();
        assertThat(floor(star.formatted("nonzero")).get(0).region().contains(0.045, 0.045)).isTrue();
    }

    @Test
    void gradientCountsAsItsAverage() {
        String defs = "<defs><linearGradient id='g'><stop offset='0' stop-color='black'/><stop offset='1' "
                + "style='stop-color:#ffffff'/></linearGradient>"
                + "<radialGradient id='h' href='#g'/>"
                + "<linearGradient id='k'><stop offset='50%' stop-color='rgb(100,0,0)'/><stop offset='.5' "
                        + "stop-color='rgb(0,0,200)'/></linearGradient></defs>";
        assertThat(colour(defs + "<rect width='9' height='9' fill='url(#g)'/>")).isEqualTo("128 128 128");
        assertThat(colour(defs + "<rect width='9' height='9' style=\"fill:url('#h')\"/>")).isEqualTo("128 128 128");
        assertThat(colour(defs + "<rect width='9' height='9' fill='url(#k)'/>")).isEqualTo("50 0 100");
        assertThat(colour("<rect width='9' height='9' fill='url(#missing) red'/>")).isEqualTo("255 0 0");
    }

    @Test
    void textIsDecoration() {
        assertThat(floor("<text x='10' y='10' fill='red'>START</text><title>t</title><desc>d</desc>")).isEmpty();
    }
}
