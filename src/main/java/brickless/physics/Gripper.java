package brickless.physics;

import brickless.units.Angles;
import brickless.world.RobotModel.Claw;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.WeldJointDef;

/**
 * A claw: its motor turns between two stops, and once it is more than half closed a movable obstacle between its jaws
 * is held until it opens again. Things hit the jaws where they are drawn.
 */
final class Gripper {
    /** Closed further than this part of its travel, the claw holds: assumption. */
    private static final double HOLDS_FROM = 0.5;
    /** Opened further than this, it lets go: assumption. */
    private static final double LETS_GO_AT = 0.4;

    private final Body robot;
    private final Shaft shaft;
    private final double open;
    private final double travel;
    private final ObstacleBody[] within;
    private final int[] touches;
    private int count;
    private Joint grip;
    private ObstacleBody held;

    Gripper(Body robot, Shaft shaft, Claw claw, int obstacles) {
        this.robot = robot;
        this.shaft = shaft;
        double sign = claw.inverted() ? -1 : 1;
        this.open = Angles.radiansFromDegrees(sign * claw.minDegrees());
        double closed = Angles.radiansFromDegrees(sign * claw.maxDegrees());
        this.travel = closed - open;
        this.within = new ObstacleBody[obstacles];
        this.touches = new int[obstacles];
        shaft.setStops(Math.min(open, closed), Math.max(open, closed));
    }

    /** An obstacle came between the jaws or left them. */
    void reach(ObstacleBody obstacle, int change) {
        for (int i = 0; i < count; i++) {
            if (within[i] == obstacle) {
                touches[i] += change;
                if (touches[i] == 0) {
                    forget(i);
                }
                return;
            }
        }
        if (change > 0) {
            within[count] = obstacle;
            touches[count++] = change;
        }
    }

    private void forget(int i) {
        count--;
        for (int k = i; k < count; k++) {
            within[k] = within[k + 1];
            touches[k] = touches[k + 1];
        }
    }

    /** Takes hold or lets go, after a step. */
    void finish() {
        double closed = travel == 0 ? 0 : (shaft.angleRadians() - open) / travel;
        if (grip == null && closed >= HOLDS_FROM && count > 0) {
            hold(within[0]);
        } else if (grip != null && closed < LETS_GO_AT) {
            release();
        }
    }

    private void hold(ObstacleBody obstacle) {
        WeldJointDef weld = new WeldJointDef();
        weld.initialize(robot, obstacle.body, obstacle.body.getWorldCenter());
        weld.collideConnected = true;
        grip = robot.getWorld().createJoint(weld);
        held = obstacle;
    }

    /** Lets go of whatever is held. */
    void release() {
        if (grip != null) {
            robot.getWorld().destroyJoint(grip);
            grip = null;
            held = null;
        }
    }

    /** What is held, or null. */
    ObstacleBody held() {
        return held;
    }
}
