package brickless.world.svg;

import brickless.units.Lengths;
import brickless.world.DescriptionException;
import brickless.world.Obstacle;
import brickless.world.Point2;
import java.util.ArrayList;
import java.util.List;

/** Makes an obstacle of shapes that form one body. */
final class ObstacleBuilder {
    /** Default density of movable things: assumption, an empty toy box or a foam block. Kilograms per cubic metre. */
    static final double DENSITY = 100;
    /** Default coefficient of friction against the floor: assumption, cardboard or plastic on a mat. */
    static final double FRICTION = 0.5;
    /** Default height: INTERFACES of the world format. */
    static final double HEIGHT_MILLIMETRES = 100;
    private static final double LEAST_MASS = 0.001;
    private static final double GREATEST_MASS = 1_000;

    private ObstacleBuilder() {}

    static boolean isSolid(Meaning meaning) throws DescriptionException {
        return meaning.has("data-solid")
                && !meaning.choice("data-solid", "fixed", "fixed", "movable", "none").equals("none");
    }

    static Obstacle build(SvgDocument document, String id, List<DrawnShape> shapes) throws DescriptionException {
        List<List<Point2>> outlines = new ArrayList<>();
        for (DrawnShape shape : shapes) {
            try {
                outlines.addAll(SolidOutline.of(shape));
            } catch (MalformedValueException e) {
                throw document.error(shape.element(), e.getMessage());
            }
        }
        Meaning meaning = shapes.get(0).scope().meaning();
        double height = Lengths.metresFromMillimetres(meaning.number("data-height-mm", HEIGHT_MILLIMETRES, 1, 10_000));
        double area = outlines.stream().mapToDouble(ring -> Rings.doubleArea(ring) / 2).sum();
        double usual = Math.max(LEAST_MASS, Math.min(GREATEST_MASS, area * height * DENSITY));
        boolean movable = meaning.choice("data-solid", "fixed", "fixed", "movable", "none").equals("movable");
        double mass = meaning.number("data-mass-kg", usual, LEAST_MASS, GREATEST_MASS);
        return new Obstacle(id, outlines, movable, mass, height, meaning.number("data-friction", FRICTION, 0, 5),
                meaning.flag("data-sound-absorbing"), WorldAssembler.shownColour(shapes.get(0)));
    }
}
