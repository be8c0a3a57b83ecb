package brickless.world.svg;

import static brickless.world.svg.Drawings.robotError;
import static brickless.world.svg.Drawings.robotText;
import static brickless.world.svg.Drawings.worldError;
import static brickless.world.svg.Drawings.worldText;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Every complaint is one line: file, line of the element, element, what is wrong, what is allowed. */
class ErrorsTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "<rect id='w' data-solid='fxied' width='9' height='9'/> | test.svg:2: w: data-solid=\"fxied\" is not known; "
                + "did you mean fixed?; allowed: fixed, movable, none",
        "<rect data-sold='fixed' width='9' height='9'/> | test.svg:2: <rect>: unknown attribute data-sold; did you "
                + "mean data-solid?; allowed in a world file: data-ambient-lux, "
                + "data-beacon",
        "<rect data-port='A' width='9' height='9'/> | test.svg:2: <rect>: data-port belongs in a robot file, this is "
                + "a world file",
        "<rect data-beacon='5' width='9' height='9'/> | test.svg:2: <rect>: data-beacon=\"5\" is not a number in "
                + "range; allowed: 1 to 4",
        "<rect data-beacon='1.5' width='9' height='9'/> | data-beacon is a channel; allowed: 1, 2, 3, 4",
        "<rect data-lamp-lux='-3' width='9' height='9'/> | data-lamp-lux=\"-3\" is not a number in range; allowed: 0 "
                + "to 200000",
        "<g data-ambient-lux='5'/> | data-ambient-lux is said of the whole drawing; put it on the outermost svg",
        "<rect data-lamp-lux='bright' width='9' height='9'/> | data-lamp-lux=\"bright\" is not a number in range",
        "<rect data-edge='clif' width='9' height='9'/> | data-edge=\"clif\" is not known; did you mean cliff?; "
                + "allowed: cliff",
        "<rect data-zone='' width='9' height='9'/> | test.svg:2: <rect>: data-zone needs a name",
        "<line data-zone='z' x2='9'/> | this shape needs an area",
        "<rect data-zone='z' data-solid='fixed' width='9' height='9'/> | cannot be a zone, a table edge and "
                + "something solid at once",
        "<rect data-solid='movable' data-mass-kg='0' width='9' height='9'/> | data-mass-kg=\"0\" is not a number in "
                + "range; allowed: 0.001 to 1000",
        "<rect data-solid='movable' data-mass-kg='1kg' width='9' height='9'/> | data-mass-kg=\"1kg\" is not a number "
                + "in range",
        "<rect data-solid='movable' data-friction='NaN' width='9' height='9'/> | data-friction=\"NaN\" is not a "
                + "number in range; allowed: 0 to 5",
        "<rect data-solid='fixed' data-sound-absorbing='maybe' width='9' height='9'/> | "
                + "data-sound-absorbing=\"maybe\" is not known; allowed: true, false, yes, no",
        "<g data-body='two'/> | data-body=\"two\" is not known; allowed: one",
        "<polygon id='bow' data-solid='fixed' points='0,0 90,90 90,0 0,90'/> | test.svg:2: bow: the outline of a "
                + "solid shape crosses or touches itself",
        "<path data-solid='fixed' d='M0,0h50v50h-50z M25,25h50v50h-50z'/> | two outlines of a solid shape cross or "
                + "touch each other",
        "<rect data-solid='fixed' width='0' height='9'/> | a solid shape needs an area",
        "<rect data-solid='fixed' width='0.1' height='1'/> | a solid shape needs an area of at least 1 square "
                + "millimetre",
        "<line data-solid='fixed' x2='90' stroke='none'/> | a solid shape needs an area",
        "<rect data-solid='fixed' fill='none' width='9' height='9'/> | a solid shape with neither fill nor stroke "
                + "cannot be seen",
        "<g id='e' data-body='one' data-solid='fixed'/> | test.svg:2: e: has data-solid but holds no shape",
        "<rect data-robot='r' width='9' height='9'/> | data-robot on <rect>; allowed on: g, use",
        "<g data-robot=''/> | data-robot needs a name",
        "<g data-robot='r'/><g id='again' data-robot='r'/> | test.svg:2: again: two robots are called r",
        "<g data-robot='r' transform='scale(-1,1)'/> | the robot r is mirrored or squeezed flat",
        "<use id='u' href='#nowhere'/> | test.svg:2: u: use refers to #nowhere, but no element has this id",
        "<rect id='box'/><use href='#bx'/> | no element has this id; did you mean box?",
        "<use href='other.svg#x'/> | use refers to \"other.svg#x\"; allowed: #id of an element in the same drawing",
        "<g id='a'><use id='u' href='#a'/></g> | test.svg:2: u: use of #a leads back to itself",
        "<rectangle id='r' width='9' height='9'/> | test.svg:2: r: <rectangle> is not an element that can be drawn",
        "<circl r='9'/> | <circl> is not an element that can be drawn; did you mean circle?; allowed: a, circle",
        "<rect width='9' height='9' fill='rde'/> | \"rde\" is not a colour; allowed: a name such as red",
        "<rect width='9' height='9' fill='gren'/> | \"gren\" is not a colour; allowed: a name such as red, #rgb, "
                + "#rrggbb, rgb(), hsl(), none; did you mean green?",
        "<rect width='9' height='9' fill='#12345'/> | \"#12345\" is not a colour",
        "<rect width='9' height='9' fill='rgb(1,2)'/> | \"rgb(1,2)\" is not a colour",
        "<rect width='9' height='9' fill='url(#g)'/> | no gradient with this id in the drawing",
        "<pattern id='p'/><rect width='9' height='9' fill='url(#p)'/> | fill with <pattern> is not supported; "
                + "allowed: colours and gradients",
        "<rect width='9' height='9' clip-path='url(#c)'/> | clip-path and mask are not supported; cut the shape itself",
        "<g mask='url(#c)'><rect id='m' width='9' height='9'/></g> | test.svg:2: m: clip-path and mask are not "
                + "supported",
        "<rect width='9' height='9' style='transform:rotate(5deg)'/> | style: transform is not supported in CSS; use "
                + "the attribute transform",
        "<rect width='9ft' height='9'/> | width=\"9ft\": unit is not supported here; allowed: none, mm, cm, in, pt, "
                + "pc, px, %",
        "<rect width='wide' height='9'/> | width=\"wide\" is not a length",
        "<rect width='-9' height='9'/> | width=\"-9\" must not be negative",
        "<rect x='1e300' width='9' height='9'/> | the number 1e300 is out of range",
        "<rect width='9' height='9' transform='turn(5)'/> | transform: \"turn(5)\" is not known; allowed: matrix, "
                + "translate, scale, rotate, skewX, skewY",
        "<rect width='9' height='9' transform='rotate(5'/> | transform: ) is expected at the end",
        "<rect width='9' height='9' transform='matrix(1 2 3)'/> | transform: matrix with 3 numbers",
        "<path d='L5,5'/> | path data must begin with M",
        "<path d='M0,0 X5'/> | path data: a command is expected at \"X5\"",
        "<path d='M0,0 L5'/> | a number is expected at the end",
        "<path d='M0,0 A5,5 0 2 0 9,9'/> | an arc flag (0 or 1) is expected at \"2 0 9,9\"",
        "<polygon points='0,0 5'/> | points holds an odd number of values",
        "<line x2='9' stroke='red' stroke-width='-1'/> | stroke-width must not be negative",
        "<line x2='9' stroke='red' stroke-dasharray='5 -1'/> | stroke-dasharray must not hold negative lengths",
        "<style id='s'>g rect { fill: red }</style> | test.svg:2: s: style: the selector \"g rect\" is not "
                + "supported; allowed: tag, .class",
        "<style>rect { fill: red</style> | style: } is missing",
        "<image width='9' height='9'/> | the image has no href; allowed: an embedded image (data:)",
        "<image href='x.png'/> | an image needs width and height in millimetres",
        "<svg viewBox='0 0 0 5'/> | viewBox=\"0 0 0 5\" is not four numbers: minX minY width height, with width and "
                + "height above 0",
    })
    void worldComplaint(String body, String message) {
        assertThat(worldError(worldText(body))).startsWith("test.svg:2: ").contains(message).doesNotContain("\n");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "<rect id='w' data-part='weel' width='9' height='9'/> | test.svg:3: w: data-part=\"weel\" is not known; did "
                + "you mean wheel?; allowed: chassis, wheel, caster, sensor, turret, claw, arm",
        "<rect data-part='wheel' width='9' height='9'/> | a motor needs data-port; allowed: A, B, C, D",
        "<rect data-part='wheel' data-port='S1' width='9' height='9'/> | data-port=\"S1\" is not a port for a motor; "
                + "allowed: A, B, C, D",
        "<rect data-part='wheel' data-port='A' data-motor='big' width='9' height='9'/> | data-motor=\"big\" is not "
                + "known; allowed: large, medium, nxt",
        "<rect data-part='wheel' data-port='A' data-diameter-mm='0' width='9' height='9'/> | data-diameter-mm=\"0\" "
                + "is not a number in range; allowed: 5 to 500",
        "<rect data-part='wheel' data-port='A' data-gear-ratio='-1' width='9' height='9'/> | data-gear-ratio=\"-1\" "
                + "is not a number in range; allowed: 0.01 to 100",
        "<path data-part='wheel' data-port='A' d='M5,5h0'/> | the wheel has no size",
        "<rect data-part='wheel' data-port='A' width='0' height='9'/> | draws nothing; it needs a shape that shows "
                + "its place",
        "<g data-part='wheel' data-port='A'/> | draws nothing",
        "<rect data-part='wheel' data-port='A' x='2000' width='9' height='9'/> | lies more than 1 m from the robot's "
                + "origin",
        "<rect id='l' data-part='wheel' data-port='A' width='9' height='9'/><rect id='r' data-part='wheel' "
                + "data-port='A' width='9' height='9'/> | test.svg:3: r: port A is taken already by l in line 3",
        "<rect data-part='sensor' data-port='S1' width='9' height='9'/> | a sensor needs data-sensor; allowed: "
                + "ev3-touch, ev3-color",
        "<rect data-part='sensor' data-port='S1' data-sensor='ev3-colour' width='9' height='9'/> | "
                + "data-sensor=\"ev3-colour\" is not known; did you mean ev3-color?",
        "<rect data-part='sensor' data-port='1' data-sensor='ev3-gyro' width='9' height='9'/> | data-port=\"1\" is "
                + "not a port for a sensor; allowed: S1, S2, S3, S4",
        "<rect data-part='sensor' data-port='S1' data-sensor='ev3-gyro' data-height-mm='-1' width='9' height='9'/> | "
                + "data-height-mm=\"-1\" is not a number in range",
        "<rect data-part='claw' data-port='A' data-min-degrees='50' data-max-degrees='50' width='9' height='9'/> | "
                + "data-min-degrees must be below data-max-degrees",
        "<g data-part='claw' data-port='A'><path d='M0,0h9' fill='none' stroke='red'/></g> | holds no filled shape",
        "<g data-part='turret' data-port='A' data-pivot='x'/> | data-pivot must be two numbers",
        "<g data-part='turret' data-port='A'><rect id='w' data-part='wheel' data-port='B' width='9' height='9'/></g> "
                + "| test.svg:3: w: a wheel cannot be inside another part; allowed inside a turret: sensor",
        "<g data-part='turret' data-port='A'><rect data-part='sensor' data-sensor='ev3-gyro' width='9' "
                + "height='9'/></g> | a sensor needs data-port",
        "<polygon data-part='chassis' points='0,0 90,90 90,0 0,90'/> | the outline of a solid shape crosses or "
                + "touches itself",
        "<rect data-beacon='1' width='9' height='9'/> | data-beacon belongs in a world file, this is a robot file",
    })
    void robotComplaint(String body, String message) {
        assertThat(robotError(robotText(body))).startsWith("test.svg:3: ").contains(message).doesNotContain("\n");
    }

    @Test
    void robotWithoutChassis() {
        assertThat(robotError("<svg><circle r='5'/></svg>"))
                .isEqualTo("test.svg:1: <svg>: the robot has no data-part=\"chassis\"");
    }

    @Test
    void errorsOfInheritedAttributesPointAtTheGroup() {
        assertThat(worldError("<svg viewBox='0 0 9 9'>\n<g id='walls'\n data-solid='soft'>\n<rect width='5' "
                + "height='5'/></g></svg>"))
                .startsWith("test.svg:2: walls: data-solid=\"soft\" is not known");
    }

    @Test
    void lineIsWhereTheTagBegins() {
        String text = "<svg viewBox='0 0 9 9'>\n<!-- <rect> \n -->\n<style>\n<![CDATA[ b { content: \"<b>\" } "
                + "]]>\n</style>\n<?x <y> ?>\n<rect\n  id='late'\n  width='5'\n  height='x'/></svg>";
        assertThat(worldError(text)).startsWith("test.svg:8: late: ");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "<svg/> | test.svg:1: <svg>: the drawing has no size; give svg a viewBox in millimetres",
        "<svg viewBox='0 0 10'/> | viewBox=\"0 0 10\" is not four numbers: minX minY width height in millimetres",
        "<svg viewBox='0 0 10 -5'/> | with width and height above 0",
        "<svg viewBox='0 0 10 5 7'/> | is not four numbers",
        "<svg viewBox='a'/> | is not four numbers",
        "<svg viewBox='0 0 1e6 5'/> | a drawing of this size cannot be simulated; allowed: 1 to 100000 mm",
        "<svg viewBox='0 0 100000 100000'/> | a drawing of this size cannot be simulated",
        "<svg viewBox='0 0 0.5 0.5'/> | a drawing of this size cannot be simulated",
        "<svg width='100%' height='5'/> | width=\"100%\": unit is not supported here",
    })
    void pageComplaint(String text, String message) {
        assertThat(worldError(text)).startsWith("test.svg:1: <svg>: ").contains(message);
    }
}
