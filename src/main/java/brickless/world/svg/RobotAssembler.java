package brickless.world.svg;

import brickless.units.Angles;
import brickless.units.Lengths;
import brickless.world.DescriptionException;
import brickless.world.MotorType;
import brickless.world.Point2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Caster;
import brickless.world.RobotModel.Claw;
import brickless.world.RobotModel.SensorMount;
import brickless.world.RobotModel.Turret;
import brickless.world.RobotModel.Wheel;
import brickless.world.SensorType;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Gives the shapes of a robot file their meaning. One use per drawing. */
final class RobotAssembler implements DrawingVisitor {
    /** The percentage base of a robot drawing, which need not have a size. */
    private static final Viewport NO_PAGE = new Viewport(1_000, 1_000);

    private final SvgDocument document;
    private final DrawingWalker walker;
    private final RobotPart parts;
    private final ElementIds ids = new ElementIds();
    private final List<List<Point2>> chassis = new ArrayList<>();
    private final List<Wheel> wheels = new ArrayList<>();
    private final List<Caster> casters = new ArrayList<>();
    private final List<SensorMount> sensors = new ArrayList<>();
    private final List<Turret> turrets = new ArrayList<>();
    private final List<Claw> claws = new ArrayList<>();
    private double mass;
    /** Outlines of the group that is being read; null outside of chassis, turret and claw. */
    private List<List<Point2>> body;
    private Optional<String> turret = Optional.empty();

    private RobotAssembler(SvgDocument document) throws DescriptionException {
        this.document = document;
        this.walker = new DrawingWalker(document, NO_PAGE);
        this.parts = new RobotPart(document);
    }

    static RobotModel assemble(SvgDocument document) throws DescriptionException {
        Vocabulary.ROBOT.check(document);
        RobotAssembler assembler = new RobotAssembler(document);
        assembler.walker.walk(assembler);
        return assembler.robot();
    }

    private RobotModel robot() throws DescriptionException {
        if (chassis.isEmpty()) {
            throw document.error(document.root(), "the robot has no data-part=\"chassis\"");
        }
        return new RobotModel(SvgDocument.nameOf(document.file()), chassis, mass, wheels, casters, sensors, turrets,
                claws, EmbeddedImages.textOf(document));
    }

    @Override
    public boolean enter(SvgElement element, Scope scope)
            throws DescriptionException, MalformedValueException {
        if (!element.has("data-part")) {
            return false;
        }
        String kind = element.attribute("data-part");
        if (!kind.equals("sensor") && (turret.isPresent() || body != null && !kind.equals("wheel")
                && !kind.equals("caster"))) {
            throw new MalformedValueException("a " + kind
                    + " cannot be inside another part; allowed inside a turret: sensor");
        }
        switch (kind) {
            case "chassis" -> chassis(element, scope);
            case "wheel" -> wheel(element, scope);
            case "caster" -> casters.add(new Caster(ids.of(element), within(box(element, scope).centre()),
                    scope.meaning().number("data-friction", RobotDefaults.CASTER_FRICTION, 0, 2)));
            case "sensor" -> sensor(element, scope);
            case "turret" -> turret(element, scope);
            case "claw", "arm" -> claw(element, scope);
            default -> throw new MalformedValueException("data-part=\"" + LengthParser.shortened(kind)
                    + "\" is not known"
                    + Suggestion.nearest(kind, RobotPart.KINDS) + "; allowed: " + String.join(", ", RobotPart.KINDS));
        }
        return true;
    }

    @Override
    public void shape(DrawnShape shape) throws DescriptionException, MalformedValueException {
        Meaning meaning = shape.scope().meaning();
        boolean decoration = body == null || meaning.choice("data-solid", "yes", "none", "yes").equals("none");
        boolean itself = shape.element().has("data-part");
        if (!decoration && (itself || shape.isFilled())) {
            for (List<Point2> ring : SolidOutline.of(shape)) {
                for (Point2 point : ring) {
                    within(point);
                }
                body.add(ring);
            }
        }
    }

    private void chassis(SvgElement element, Scope scope) throws DescriptionException {
        chassis.addAll(outlines(element, scope));
        boolean stated = scope.meaning().has("data-mass-kg");
        if (stated || mass == 0) {
            mass += scope.meaning().number("data-mass-kg", RobotDefaults.MASS_KILOGRAMS, 0.01, 100);
        }
    }

    private List<List<Point2>> outlines(SvgElement element, Scope scope) throws DescriptionException {
        List<List<Point2>> collected = new ArrayList<>();
        List<List<Point2>> outer = body;
        body = collected;
        walker.inside(element, scope, this);
        body = outer;
        return collected;
    }

    private void wheel(SvgElement element, Scope scope) throws DescriptionException, MalformedValueException {
        Meaning meaning = scope.meaning();
        LocalBox box = box(element, scope);
        if (box.isEmpty()) {
            throw new MalformedValueException("the wheel has no size; draw it as a rectangle, seen from above");
        }
        double diameter = meaning.number("data-diameter-mm", RobotDefaults.TYRE_MILLIMETRES, 5, 500);
        wheels.add(new Wheel(ids.of(element), parts.motorPort(element), RobotPart.motor(meaning, MotorType.LARGE),
                Lengths.metresFromMillimetres(diameter), meaning.number("data-gear-ratio", 1, 0.01, 100),
                meaning.flag("data-inverted"), within(box.centre()), heading(scope), meaning.flag("data-omni"),
                RobotPart.backlash(meaning)));
    }

    private void sensor(SvgElement element, Scope scope) throws DescriptionException, MalformedValueException {
        SensorType type = parts.sensor(element, scope.meaning());
        LocalBox box = box(element, scope);
        double height = scope.meaning().number("data-height-mm", RobotDefaults.sensorHeightMillimetres(type), 0, 1_000);
        boolean middle = RobotDefaults.looksDown(type) || type == SensorType.EV3_GYRO;
        sensors.add(new SensorMount(ids.of(element), parts.sensorPort(element), type,
                within(middle ? box.centre() : box.front()), heading(scope),
                Lengths.metresFromMillimetres(height), sensorBody(element, scope, box), turret));
    }

    /** The largest filled outline, else the box around what is drawn. */
    private List<Point2> sensorBody(SvgElement element, Scope scope, LocalBox box)
            throws DescriptionException, MalformedValueException {
        List<Point2> largest = box.outline();
        double area = 0;
        for (DrawnShape shape : walker.shapesWithin(element, scope)) {
            for (List<Point2> ring : shape.isFilled() ? SolidOutline.of(shape) : List.<List<Point2>>of()) {
                if (Rings.doubleArea(ring) > area) {
                    area = Rings.doubleArea(ring);
                    largest = ring;
                }
            }
        }
        return largest;
    }

    private void turret(SvgElement element, Scope scope) throws DescriptionException, MalformedValueException {
        Meaning meaning = scope.meaning();
        String id = ids.of(element);
        int port = parts.motorPort(element);
        turret = Optional.of(id);
        List<List<Point2>> outlines = outlines(element, scope);
        turret = Optional.empty();
        turrets.add(new Turret(id, port, RobotPart.motor(meaning, MotorType.MEDIUM),
                meaning.number("data-gear-ratio", 1, 0.01, 100), meaning.flag("data-inverted"), within(pivot(scope)),
                outlines, RobotPart.backlash(meaning)));
    }

    private void claw(SvgElement element, Scope scope) throws DescriptionException, MalformedValueException {
        Meaning meaning = scope.meaning();
        double min = meaning.number("data-min-degrees", 0, -3_600, 3_600);
        double max = meaning.number("data-max-degrees", RobotDefaults.CLAW_CLOSED_DEGREES, -3_600, 3_600);
        if (!(min < max)) {
            throw new MalformedValueException("data-min-degrees must be below data-max-degrees");
        }
        int port = parts.motorPort(element);
        List<List<Point2>> outlines = outlines(element, scope);
        if (outlines.isEmpty()) {
            throw new MalformedValueException("holds no filled shape");
        }
        claws.add(new Claw(ids.of(element), port, RobotPart.motor(meaning, MotorType.MEDIUM), min, max,
                meaning.flag("data-inverted"), within(pivot(scope)), outlines));
    }

    /** {@code data-pivot="x,y"} in the part's own coordinates, else their origin. */
    private static Point2 pivot(Scope scope) throws DescriptionException {
        Point2 local = new Point2(0, 0);
        if (scope.meaning().has("data-pivot")) {
            NumberScanner in = new NumberScanner(scope.meaning().name("data-pivot"));
            try {
                double x = in.number();
                in.skipSeparator();
                local = new Point2(x, in.number());
            } catch (MalformedValueException e) {
                throw scope.meaning().error("data-pivot", "data-pivot must be two numbers, such as \"40,0\"");
            }
        }
        Point2 p = scope.toPage().apply(local);
        return new Point2(Lengths.metresFromMillimetres(p.x()), Lengths.metresFromMillimetres(p.y()));
    }

    private LocalBox box(SvgElement element, Scope scope) throws DescriptionException, MalformedValueException {
        return LocalBox.of(scope, walker.shapesWithin(element, scope));
    }

    private static double heading(Scope scope) throws DescriptionException {
        double extra = scope.meaning().number("data-heading-degrees", 0, -360, 360);
        double heading = scope.toPage().headingRadians();
        return extra == 0 ? heading : Angles.normalizedRadians(heading + Angles.radiansFromDegrees(extra));
    }

    private static Point2 within(Point2 point) throws MalformedValueException {
        if (!(Math.max(Math.abs(point.x()), Math.abs(point.y())) <= RobotDefaults.GREATEST_REACH_METRES)) {
            throw new MalformedValueException(
                    "lies more than 1 m from the robot's origin, the middle of the driven axle; units are millimetres");
        }
        return point;
    }
}
