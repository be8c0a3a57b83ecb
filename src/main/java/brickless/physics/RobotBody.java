package brickless.physics;

import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.Region;
import brickless.world.RobotModel;
import brickless.world.RobotModel.SensorMount;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/** One robot in the arena. */
public final class RobotBody implements Solid {
    final int index;
    final Body body;
    private final String name;
    private final RobotModel model;
    private final RobotAssembly assembly;
    private final Rotation rotation;
    private final Drivetrain drivetrain;
    private final Turntable[] turrets;
    private final Gripper[] grippers;
    private Bumper[] bumpers = {};
    private final Map<SensorMount, Bumper> bumpersByMount = new HashMap<>();
    private double x;
    private double y;
    private double heading;
    private double distance;
    private boolean fallen;

    RobotBody(org.jbox2d.dynamics.World world, Body ground, Entrant entrant, int index, boolean ideal, int obstacles) {
        this.index = index;
        this.name = entrant.name();
        this.model = entrant.model();
        this.assembly = new RobotAssembly(world, ground, this, entrant.start(), ideal, obstacles);
        this.body = assembly.body;
        this.drivetrain = assembly.drivetrain;
        this.rotation = drivetrain.rotation();
        this.turrets = assembly.turrets.toArray(Turntable[]::new);
        this.grippers = assembly.grippers.toArray(Gripper[]::new);
        readPose();
    }

    @Override
    public String name() {
        return name;
    }

    /** What was drawn. */
    public RobotModel model() {
        return model;
    }

    /** The output shaft at a motor port, 0 to 3; exists whether or not a motor is plugged. */
    public Shaft shaft(int port) {
        return assembly.shafts[port];
    }

    /** X of the origin (middle of the driven axle), metres. */
    public double xMetres() {
        return x;
    }

    /** Y of the origin, metres. */
    public double yMetres() {
        return y;
    }

    /** Heading, radians clockwise, not wrapped: two full turns read 4π more. */
    public double headingRadians() {
        return heading;
    }

    /** Present pose. */
    public Pose2 pose() {
        return new Pose2(x, y, heading);
    }

    /** Yaw rate, radians per second, clockwise positive. */
    public double yawRateRadiansPerSecond() {
        return body.getAngularVelocity();
    }

    /** Length of the path of the origin so far, metres; being moved by hand does not count. */
    public double distanceMetres() {
        return distance;
    }

    /** Whether a wheel has left the table. */
    public boolean fallen() {
        return fallen;
    }

    /** The bumper of a touch sensor; added to the robot on first use. */
    public Bumper bumper(SensorMount mount) {
        Bumper bumper = bumpersByMount.get(mount);
        if (bumper == null) {
            bumper = assembly.bumper(mount);
            drivetrain.clearance().forget();
            bumpersByMount.put(mount, bumper);
            bumpers = Arrays.copyOf(bumpers, bumpers.length + 1);
            bumpers[bumpers.length - 1] = bumper;
        }
        return bumper;
    }

    /** Place and direction of a sensor now. */
    public void aim(SensorMount mount, Aim out) {
        double px = mount.position().x();
        double py = mount.position().y();
        double direction = mount.headingRadians();
        Turntable turret = assembly.turret(mount);
        if (turret != null) {
            double angle = turret.angleRadians(body);
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            Point2 pivot = turret.description.pivot();
            double dx = px - pivot.x();
            double dy = py - pivot.y();
            px = pivot.x() + cos * dx - sin * dy;
            py = pivot.y() + sin * dx + cos * dy;
            direction += angle;
        }
        double cos = rotation.cos();
        double sin = rotation.sin();
        out.x = x + cos * px - sin * py;
        out.y = y + sin * px + cos * py;
        out.headingRadians = heading + direction;
    }

    /** Clockwise angle of a turret against the robot, radians, by its place in the model's list. */
    public double turretAngleRadians(int turret) {
        return turrets[turret].angleRadians(body);
    }

    /** What a claw holds, by the claw's place in the model's list. */
    public Optional<ObstacleBody> held(int claw) {
        return Optional.ofNullable(grippers[claw].held());
    }

    /** Kinetic energy of the body without its motors, joules. */
    public double kineticEnergyJoules() {
        double vx = Decimetres.metres(body.m_linearVelocity.x);
        double vy = Decimetres.metres(body.m_linearVelocity.y);
        double spin = body.m_angularVelocity;
        return (body.m_mass * (vx * vx + vy * vy) + Decimetres.inertia(body.m_I) * spin * spin) / 2;
    }

    void prepare(double dt) {
        drivetrain.prepare(dt);
    }

    void finish(double dt) {
        drivetrain.finish();
        for (Turntable turret : turrets) {
            turret.finish();
        }
        double oldX = x;
        double oldY = y;
        readPose();
        distance += StrictMath.sqrt((x - oldX) * (x - oldX) + (y - oldY) * (y - oldY));
        for (Bumper bumper : bumpers) {
            bumper.finish(dt);
        }
        for (Gripper gripper : grippers) {
            gripper.finish();
        }
    }

    private void readPose() {
        x = Decimetres.metres(body.getPosition().x);
        y = Decimetres.metres(body.getPosition().y);
        heading = body.getAngle();
        rotation.to(body.getAngle());
    }

    /** Notes whether a driven wheel is over the edge; true when that happens for the first time. */
    boolean fallsOff(Region table) {
        if (fallen) {
            return false;
        }
        double cos = rotation.cos();
        double sin = rotation.sin();
        for (int i = 0; i < model.wheels().size(); i++) {
            Point2 p = model.wheels().get(i).position();
            if (!table.contains(x + cos * p.x() - sin * p.y(), y + sin * p.x() + cos * p.y())) {
                fallen = true;
                return true;
            }
        }
        return false;
    }

    /** Puts the robot elsewhere, as a hand would: the heading turns the short way. */
    void place(Pose2 pose) {
        releaseAll();
        double turn = StrictMath.IEEEremainder(pose.headingRadians() - heading, 2 * StrictMath.PI);
        float angle = (float) (heading + turn);
        double change = (double) angle - heading;
        float oldAngle = body.getAngle();
        body.setTransform(new Vec2(Decimetres.of(pose.x()), Decimetres.of(pose.y())), angle);
        body.setLinearVelocity(new Vec2());
        body.setAngularVelocity(0);
        drivetrain.clearance().forget();
        for (Turntable turret : turrets) {
            if (turret.body != null) {
                Point2 pivot = turret.description.pivot();
                Vec2 at = body.getWorldPoint(new Vec2(Decimetres.of(pivot.x()), Decimetres.of(pivot.y())));
                turret.body.setTransform(at, (float) (turret.body.getAngle() - oldAngle + heading + change));
                turret.body.setLinearVelocity(new Vec2());
                turret.body.setAngularVelocity(0);
            }
        }
        readPose();
    }

    void release(ObstacleBody obstacle) {
        for (Gripper gripper : grippers) {
            if (gripper.held() == obstacle) {
                gripper.release();
            }
        }
    }

    private void releaseAll() {
        for (Gripper gripper : grippers) {
            gripper.release();
        }
    }
}
