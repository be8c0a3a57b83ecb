package brickless.physics;

import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Caster;
import brickless.world.RobotModel.Claw;
import brickless.world.RobotModel.SensorMount;
import brickless.world.RobotModel.Turret;
import brickless.world.RobotModel.Wheel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.joints.RevoluteJointDef;

/** Builds the bodies, joints and constraints of one robot. Used once, by {@link RobotBody}. */
final class RobotAssembly {
    /** Friction of rubber tyres on paper or laminate: assumption. */
    static final double TYRE_FRICTION = 0.8;
    /** Friction of LEGO plastic against walls and boxes (mixed with theirs): assumption. */
    static final double CHASSIS_FRICTION = 0.3;
    /** Mass of a turret with what it carries, kg: assumption. */
    static final double TURRET_MASS = 0.06;
    /** How far around its drawn outline a claw can take hold, metres: assumption. */
    static final double CLAW_REACH = 0.01;
    private static final int PORTS = 4;
    private static final Point2 ORIGIN = new Point2(0, 0);

    final Body body;
    final Shaft[] shafts = new Shaft[PORTS];
    final List<Turntable> turrets = new ArrayList<>();
    final List<Gripper> grippers = new ArrayList<>();
    final Drivetrain drivetrain;
    private final org.jbox2d.dynamics.World world;
    private final RobotModel model;
    private final int filterGroup;

    RobotAssembly(org.jbox2d.dynamics.World world, Body ground, RobotBody owner, Pose2 start, boolean ideal,
            int obstacles) {
        this.world = world;
        this.model = owner.model();
        this.filterGroup = -1 - owner.index;
        Arrays.setAll(shafts, port -> new Shaft());
        body = body(start.x(), start.y(), start.headingRadians(), owner);
        List<List<Point2>> pieces = Shapes.pieces(model.chassis());
        double area = Shapes.area(pieces);
        if (area <= 0 || model.massKilograms() <= 0) {
            throw new IllegalArgumentException("robot " + owner.name() + " needs a chassis with area and mass");
        }
        Shapes.attach(body, pieces, ORIGIN, fixture(model.massKilograms() / area));
        for (Turret turret : model.turrets()) {
            turrets.add(turret(turret, owner, ideal));
        }
        for (Claw claw : model.claws()) {
            grippers.add(gripper(claw, obstacles));
        }
        drivetrain = drivetrain(ground, Shapes.centroid(pieces), ideal);
    }

    private Body body(double x, double y, double heading, RobotBody owner) {
        BodyDef definition = new BodyDef();
        definition.type = BodyType.DYNAMIC;
        definition.position.set(Decimetres.of(x), Decimetres.of(y));
        definition.angle = (float) heading;
        definition.allowSleep = false;
        Body created = world.createBody(definition);
        created.setUserData(owner);
        return created;
    }

    private FixtureDef fixture(double kilogramsPerSquareMetre) {
        FixtureDef fixture = new FixtureDef();
        fixture.friction = (float) CHASSIS_FRICTION;
        fixture.density = (float) (kilogramsPerSquareMetre / (Decimetres.PER_METRE * Decimetres.PER_METRE));
        fixture.filter.groupIndex = filterGroup;
        return fixture;
    }

    private Turntable turret(Turret turret, RobotBody owner, boolean ideal) {
        Shaft shaft = shafts[turret.port()];
        List<List<Point2>> pieces = Shapes.pieces(turret.outlines());
        if (pieces.isEmpty()) {
            return new Turntable(turret, shaft, null, ideal);
        }
        Vec2 pivot = body.getWorldPoint(new Vec2(Decimetres.of(turret.pivot().x()), Decimetres.of(turret.pivot().y())));
        Body turning = body(Decimetres.metres(pivot.x), Decimetres.metres(pivot.y), body.getAngle(), owner);
        Shapes.attach(turning, pieces, turret.pivot(), fixture(TURRET_MASS / Shapes.area(pieces)));
        RevoluteJointDef hinge = new RevoluteJointDef();
        hinge.initialize(body, turning, pivot);
        world.createJoint(hinge);
        return new Turntable(turret, shaft, turning, ideal);
    }

    private Gripper gripper(Claw claw, int obstacles) {
        List<List<Point2>> pieces = Shapes.pieces(claw.outlines());
        Shapes.attach(body, pieces, ORIGIN, fixture(0));
        Gripper gripper = new Gripper(body, shafts[claw.port()], claw, obstacles);
        if (!pieces.isEmpty()) {
            FixtureDef reach = fixture(0);
            reach.isSensor = true;
            reach.userData = gripper;
            Shapes.attach(body, List.of(boxAround(pieces)), ORIGIN, reach);
        }
        return gripper;
    }

    private static List<Point2> boxAround(List<List<Point2>> pieces) {
        double left = Double.POSITIVE_INFINITY;
        double top = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        for (List<Point2> piece : pieces) {
            for (Point2 p : piece) {
                left = Math.min(left, p.x() - CLAW_REACH);
                right = Math.max(right, p.x() + CLAW_REACH);
                top = Math.min(top, p.y() - CLAW_REACH);
                bottom = Math.max(bottom, p.y() + CLAW_REACH);
            }
        }
        return List.of(new Point2(left, top), new Point2(right, top), new Point2(right, bottom),
                new Point2(left, bottom));
    }

    /** Adds the outline of a touch sensor. */
    Bumper bumper(SensorMount mount) {
        Bumper bumper = new Bumper();
        FixtureDef fixture = fixture(0);
        fixture.userData = bumper;
        Turntable carrier = turret(mount);
        boolean turning = carrier != null && carrier.body != null;
        Shapes.attach(turning ? carrier.body : body, ConvexParts.of(BumperOutline.of(mount)),
                turning ? carrier.description.pivot() : ORIGIN, fixture);
        return bumper;
    }

    /** The turret that carries a sensor, or null. */
    Turntable turret(SensorMount mount) {
        for (Turntable turret : turrets) {
            if (mount.turret().isPresent() && turret.description.id().equals(mount.turret().get())) {
                return turret;
            }
        }
        return null;
    }

    private Drivetrain drivetrain(Body ground, Point2 centre, boolean ideal) {
        List<Point2> supports = new ArrayList<>();
        model.wheels().forEach(wheel -> supports.add(wheel.position()));
        model.casters().forEach(caster -> supports.add(caster.position()));
        double[] shares = SupportLoads.shares(supports, centre);
        double weight = model.massKilograms() * ObstacleBody.GRAVITY;
        int wheels = model.wheels().size();
        Tyre[] tyres = new Tyre[wheels];
        double[] grip = new double[wheels];
        for (int i = 0; i < wheels; i++) {
            Wheel wheel = model.wheels().get(i);
            tyres[i] = new Tyre(wheel, shafts[wheel.port()], ideal);
            grip[i] = ideal ? Double.POSITIVE_INFINITY : TYRE_FRICTION * shares[i] * weight;
        }
        Skid[] skids = new Skid[model.casters().size()];
        double[] loads = new double[skids.length];
        for (int i = 0; i < skids.length; i++) {
            Caster caster = model.casters().get(i);
            skids[i] = new Skid(caster);
            loads[i] = shares[wheels + i] * weight;
        }
        TurretGear[] gears = turrets.stream().filter(turret -> turret.body != null)
                .map(turret -> new TurretGear(body, turret))
                .toArray(TurretGear[]::new);
        return new Drivetrain(ground, body, shafts, tyres, grip, skids, loads, gears);
    }
}
