package brickless.physics;

import java.util.Arrays;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.SolverData;
import org.jbox2d.dynamics.contacts.Velocity;
import org.jbox2d.dynamics.joints.FrictionJointDef;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointEdge;

/**
 * Shafts, tyres, skids and turret gears of one robot as one constraint inside JBox2D's solver, so that traction, motors
 * and contacts are solved together: a robot that pushes a wall neither creeps nor shakes.
 *
 * <p>JBox2D creates joints of its own kinds only. This one therefore takes the place of an ordinary friction joint
 * (between the robot and the ground) in the robot's joint list; the ordinary joint keeps the solver's count of joints
 * right and never acts itself.
 */
final class Drivetrain extends Joint {
    /** Relaxations of all constraints per velocity iteration of the solver. */
    private static final int SWEEPS = 1;

    private final Body robot;
    private final Shaft[] shafts;
    private final boolean[] coupled;
    /** The shafts that turn in this step, or may. */
    private final Shaft[] turning;
    private int turningCount;
    private final Tyre[] tyres;
    private final double[] tyreLimits;
    private final Skid[] skids;
    private final double[] skidLoads;
    private final TurretGear[] gears;
    private final Rotation rotation = new Rotation();
    private final BodyMotion motion = new BodyMotion(rotation);
    private final Clearance clearance = new Clearance();
    private double dt;

    Drivetrain(Body ground, Body robot, Shaft[] shafts, Tyre[] tyres, double[] tyreLimits, Skid[] skids,
            double[] skidLoads, TurretGear[] gears) {
        super(ground.getWorld().getPool(), definition(ground, robot));
        this.robot = robot;
        this.shafts = shafts;
        this.coupled = new boolean[shafts.length];
        this.turning = new Shaft[shafts.length];
        this.tyres = tyres;
        this.tyreLimits = tyreLimits;
        this.skids = skids;
        this.skidLoads = skidLoads;
        this.gears = gears;
        for (int i = 0; i < shafts.length; i++) {
            coupled[i] = isCoupled(shafts[i]);
        }
        replaceOrdinaryJoint(ground.getWorld().createJoint(definition(ground, robot)));
    }

    private boolean isCoupled(Shaft shaft) {
        return Arrays.stream(tyres).anyMatch(tyre -> tyre.shaft == shaft)
                || Arrays.stream(gears).anyMatch(gear -> gear.shaft == shaft);
    }

    private static FrictionJointDef definition(Body ground, Body robot) {
        FrictionJointDef definition = new FrictionJointDef();
        definition.initialize(ground, robot, robot.getPosition());
        definition.collideConnected = true;
        return definition;
    }

    private void replaceOrdinaryJoint(Joint ordinary) {
        for (JointEdge edge = robot.m_jointList; edge != null; edge = edge.next) {
            if (edge.joint == ordinary) {
                edge.joint = this;
                return;
            }
        }
        throw new IllegalStateException("joint not found in the body's list");
    }

    /** Rotation of the robot's body. */
    Rotation rotation() {
        return rotation;
    }

    /** Room within the broad phase's boxes. */
    Clearance clearance() {
        return clearance;
    }

    /** Must be called before each step: the solver resets the mark of its own joints only. */
    void prepare(double stepSeconds) {
        m_islandFlag = false;
        dt = stepSeconds;
    }

    @Override
    public void initVelocityConstraints(SolverData data) {
        Velocity velocity = data.velocities[robot.m_islandIndex];
        motion.begin(robot, data.positions[robot.m_islandIndex]);
        motion.read(velocity);
        beginShafts();
        for (int i = 0; i < tyres.length; i++) {
            tyres[i].begin(motion, tyreLimits[i], dt);
        }
        for (int i = 0; i < skids.length; i++) {
            skids[i].begin(motion, skidLoads[i], dt);
        }
        for (TurretGear gear : gears) {
            gear.begin(motion, data, dt);
        }
        motion.write(velocity);
    }

    private void beginShafts() {
        turningCount = 0;
        for (int i = 0; i < shafts.length; i++) {
            if (coupled[i] || !shafts[i].rests()) {
                shafts[i].begin(dt);
                turning[turningCount++] = shafts[i];
            }
        }
    }

    @Override
    public void solveVelocityConstraints(SolverData data) {
        Velocity velocity = data.velocities[robot.m_islandIndex];
        motion.read(velocity);
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            for (int i = 0; i < turningCount; i++) {
                turning[i].solve();
            }
            for (TurretGear gear : gears) {
                gear.solve(motion, data);
            }
            for (Skid skid : skids) {
                skid.solve(motion);
            }
            for (Tyre tyre : tyres) {
                tyre.solve(motion);
            }
        }
        motion.write(velocity);
    }

    /** Moves the gears and the shafts on, after the step. */
    void finish() {
        motion.read(robot);
        for (Tyre tyre : tyres) {
            tyre.end(motion, dt);
        }
        for (int i = 0; i < turningCount; i++) {
            turning[i].end(dt);
        }
    }

    @Override
    public boolean solvePositionConstraints(SolverData data) {
        return true;
    }

    @Override
    public void getAnchorA(Vec2 out) {
        out.set(robot.getPosition());
    }

    @Override
    public void getAnchorB(Vec2 out) {
        out.set(robot.getPosition());
    }

    @Override
    public void getReactionForce(float inverseStep, Vec2 out) {
        out.setZero();
    }

    @Override
    public float getReactionTorque(float inverseStep) {
        return 0;
    }
}
