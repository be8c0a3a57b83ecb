package brickless.world.svg;

import brickless.units.Lengths;
import brickless.world.Beacon;
import brickless.world.DescriptionException;
import brickless.world.Lamp;
import brickless.world.Obstacle;
import brickless.world.Paint;
import brickless.world.Placement;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.Region;
import brickless.world.Rgb;
import brickless.world.World;
import brickless.world.Zone;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Gives the shapes of a world file their meaning. One use per drawing. */
final class WorldAssembler implements DrawingVisitor {
    private static final double GREATEST_LUX = 200_000;

    private final SvgDocument document;
    private final ViewBox page;
    private final DrawingWalker walker;
    private final ElementIds ids = new ElementIds();
    private final List<Paint> floor = new ArrayList<>();
    private final List<Obstacle> obstacles = new ArrayList<>();
    private final List<Zone> zones = new ArrayList<>();
    private final List<Beacon> beacons = new ArrayList<>();
    private final List<Lamp> lamps = new ArrayList<>();
    private final List<Placement> placements = new ArrayList<>();
    private final List<Region.Filled> tables = new ArrayList<>();

    private WorldAssembler(SvgDocument document) throws DescriptionException {
        this.document = document;
        this.page = PageSize.of(document);
        this.walker = new DrawingWalker(document, new Viewport(page.width(), page.height()));
    }

    static World assemble(SvgDocument document) throws DescriptionException {
        Vocabulary.WORLD.check(document);
        WorldAssembler assembler = new WorldAssembler(document);
        assembler.walker.walk(assembler);
        return assembler.world();
    }

    private World world() throws DescriptionException {
        double ambientLux = Meaning.none(document).with(document.root())
                .number("data-ambient-lux", World.LIVING_ROOM_LUX, 0, GREATEST_LUX);
        return new World(SvgDocument.nameOf(document.file()), Lengths.metresFromMillimetres(page.minX()),
                Lengths.metresFromMillimetres(page.minY()), Lengths.metresFromMillimetres(page.width()),
                Lengths.metresFromMillimetres(page.height()), floor, obstacles, zones, beacons, lamps, table(),
                placements, EmbeddedImages.textOf(document), ambientLux);
    }

    @Override
    public boolean enter(SvgElement element, Scope scope)
            throws DescriptionException, MalformedValueException {
        if (element.has("data-robot")) {
            placements.add(PlacementReader.read(document, element, scope, placements));
            return true;
        }
        if (!isOneThing(element)) {
            return false;
        }
        Meaning meaning = element.name().equals("use") ? scope.meaning().with(walker.target(element)) : scope.meaning();
        if (ObstacleBuilder.isSolid(meaning)) {
            body(element, scope);
            return true;
        }
        if (meaning.has("data-beacon") || meaning.has("data-lamp-lux")) {
            List<DrawnShape> shapes = walker.shapesWithin(element, scope);
            pointSources(ids.of(element), meaning, LocalBox.of(scope, shapes).centre());
            return true;
        }
        return false;
    }

    /** A {@code use}, or a group that says so, is one thing; other groups only hand their attributes down. */
    private static boolean isOneThing(SvgElement element) throws MalformedValueException {
        String body = element.attribute("data-body");
        if (body != null && !body.equals("one")) {
            throw new MalformedValueException("data-body=\"" + LengthParser.shortened(body)
                    + "\" is not known; allowed: one");
        }
        return body != null || element.name().equals("use");
    }

    private void body(SvgElement element, Scope scope) throws DescriptionException, MalformedValueException {
        List<DrawnShape> solid = new ArrayList<>();
        for (DrawnShape shape : walker.shapesWithin(element, scope)) {
            if (ObstacleBuilder.isSolid(shape.scope().meaning())) {
                solid.add(shape);
            } else if (!"none".equals(shape.scope().meaning().text("data-solid").orElse(""))) {
                shape(shape);
            }
        }
        if (solid.isEmpty()) {
            throw new MalformedValueException("has data-solid but holds no shape");
        }
        String id = ids.of(element);
        obstacles.add(ObstacleBuilder.build(document, id, solid));
        Meaning meaning = solid.get(0).scope().meaning();
        if (meaning.has("data-beacon") || meaning.has("data-lamp-lux")) {
            pointSources(id, meaning, LocalBox.of(scope, solid).centre());
        }
    }

    @Override
    public void shape(DrawnShape shape) throws DescriptionException, MalformedValueException {
        Meaning meaning = shape.scope().meaning();
        boolean solid = ObstacleBuilder.isSolid(meaning);
        boolean point = meaning.has("data-beacon") || meaning.has("data-lamp-lux");
        if (meaning.has("data-zone") && (solid || point || meaning.has("data-edge")) || meaning.has("data-edge")
                && (solid || point)) {
            throw new MalformedValueException(
                    "a shape cannot be a zone, a table edge and something solid at once; draw it twice");
        }
        shape.refuseClipping();
        String id = ids.of(shape.element());
        if (solid) {
            obstacles.add(ObstacleBuilder.build(document, id, List.of(shape)));
        }
        if (point) {
            pointSources(id, meaning, LocalBox.of(shape.scope(), List.of(shape)).centre());
        } else if (meaning.has("data-zone")) {
            zones.add(new Zone(meaning.name("data-zone"), area(shape)));
        } else if (meaning.has("data-edge")) {
            meaning.choice("data-edge", "cliff", "cliff");
            tables.add(area(shape));
        }
        if (!solid && !point && !meaning.has("data-zone")) {
            floor.addAll(FloorPaints.of(document, shape, id));
        }
    }

    private void pointSources(String id, Meaning meaning, Point2 position) throws DescriptionException {
        if (meaning.has("data-beacon")) {
            double channel = meaning.number("data-beacon", 1, 1, 4);
            if (channel != Math.rint(channel)) {
                throw meaning.error("data-beacon", "data-beacon is a channel; allowed: 1, 2, 3, 4");
            }
            beacons.add(new Beacon(id, (int) channel, position));
        }
        if (meaning.has("data-lamp-lux")) {
            lamps.add(new Lamp(id, meaning.number("data-lamp-lux", 0, 0, GREATEST_LUX), position));
        }
    }

    /** The inside of a closed shape, or the area of a line. */
    private static Region.Filled area(DrawnShape shape) throws MalformedValueException {
        List<List<Point2>> rings = shape.fillRings();
        if (!rings.isEmpty()) {
            return new Region.Filled(rings, shape.scope().style().evenOdd());
        }
        List<List<Point2>> pieces = shape.strokePieces();
        if (pieces.isEmpty()) {
            throw new MalformedValueException("this shape needs an area; draw a closed shape or a line with a stroke");
        }
        return new Region.Filled(pieces, false);
    }

    private Optional<Region> table() {
        if (tables.size() <= 1) {
            return tables.stream().<Region>map(table -> table).findFirst();
        }
        List<List<Point2>> rings = new ArrayList<>();
        tables.forEach(table -> rings.addAll(table.rings()));
        return Optional.of(new Region.Filled(rings, false));
    }

    /** Colour a body is shown in: its fill, else its line. */
    static Rgb shownColour(DrawnShape shape) {
        Style style = shape.scope().style();
        return style.fill().or(style::stroke).orElse(Colour.BLACK).rgb();
    }

    static Pose2 pose(Affine toPage) {
        return new Pose2(Lengths.metresFromMillimetres(toPage.e()), Lengths.metresFromMillimetres(toPage.f()),
                toPage.headingRadians());
    }
}
