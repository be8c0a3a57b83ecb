package brickless.world.svg;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import brickless.world.DescriptionException;
import brickless.world.Point2;
import brickless.world.RobotModel;
import brickless.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Small drawings for tests, and their points in millimetres. */
final class Drawings {
    private Drawings() {}

    /** A world of one square metre; the body begins in line 2. */
    static String worldText(String body) {
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1000 1000\">\n" + body + "\n</svg>";
    }

    static World world(String body) {
        try {
            return SvgWorldReader.readText("test.svg", worldText(body));
        } catch (DescriptionException e) {
            throw new AssertionError(e.getMessage(), e);
        }
    }

    /** A robot with a chassis; the body begins in line 3. */
    static String robotText(String body) {
        return "<svg xmlns=\"http://www.w3.org/2000/svg\">\n<rect data-part=\"chassis\" x=\"-50\" y=\"-40\" "
                + "width=\"100\" height=\"80\"/>\n" + body + "\n</svg>";
    }

    static RobotModel robot(String body) {
        try {
            return SvgRobotReader.readText("test.svg", robotText(body));
        } catch (DescriptionException e) {
            throw new AssertionError(e.getMessage(), e);
        }
    }

    /** The outlines of the only obstacle, as {@code "x,y x,y …"} in millimetres with up to two decimals. */
    static List<String> outlines(String body) {
        World world = world(body);
        assertThat(world.obstacles()).hasSize(1);
        return world.obstacles().get(0).outlines().stream().map(Drawings::text).toList();
    }

    /** The only outline of the only obstacle. */
    static String outline(String body) {
        List<String> outlines = outlines(body);
        assertThat(outlines).hasSize(1);
        return outlines.get(0);
    }

    static String text(List<Point2> points) {
        List<String> parts = new ArrayList<>();
        for (Point2 p : points) {
            parts.add(number(p.x()) + "," + number(p.y()));
        }
        return String.join(" ", parts);
    }

    static double area(List<Point2> ring) {
        return Rings.doubleArea(ring) / 2 * 1e6;
    }

    static String worldError(String text) {
        return catchThrowableOfType(DescriptionException.class, () -> SvgWorldReader.readText("test.svg", text))
                .getMessage();
    }

    static String robotError(String text) {
        return catchThrowableOfType(DescriptionException.class, () -> SvgRobotReader.readText("test.svg", text))
                .getMessage();
    }

    private static String number(double metres) {
        double rounded = Math.rint(metres * 1e5) / 100;
        return rounded == Math.rint(rounded) ? String.valueOf((long) rounded)
                : String.format(Locale.ROOT, "%.2f", rounded).replaceAll("0+$", "");
    }
}
