package brickless.device.sensor;

import brickless.physics.Aim;
import brickless.physics.RayFan;
import brickless.physics.RobotBody;
import brickless.world.RobotModel.SensorMount;

/** Where a sensor is mounted, what is around it, and its own noise. */
final class SensorSite {
    /**
     * Sound and infrared spread downwards: an obstacle is met if it reaches this close to the sensor's height, metres:
     * assumption.
     */
    private static final double BEAM_BELOW = 0.02;

    private final RobotBody robot;
    private final SensorMount mount;
    private final Surroundings surroundings;
    private final RemoteControl remote;
    private final Noise noise;
    private final Aim aim = new Aim();
    private boolean pushed;

    SensorSite(RobotBody robot, SensorMount mount, Surroundings surroundings, RemoteControl remote) {
        this.robot = robot;
        this.mount = mount;
        this.surroundings = surroundings;
        this.remote = remote;
        this.noise = surroundings.noise(robot.name(), mount.port());
    }

    RobotBody robot() {
        return robot;
    }

    SensorMount mount() {
        return mount;
    }

    Surroundings surroundings() {
        return surroundings;
    }

    RemoteControl remote() {
        return remote;
    }

    Noise noise() {
        return noise;
    }

    boolean ideal() {
        return surroundings.ideal();
    }

    /** Present place and direction; the same object each time. */
    Aim aim() {
        robot.aim(mount, aim);
        return aim;
    }

    /** Casts rays from here; the robot itself and what is low are not met. */
    void cast(RayFan fan, RayFan.Visitor visitor) {
        fan.cast(surroundings.arena(), aim(), leastHeightMetres(), robot, visitor);
    }

    double leastHeightMetres() {
        return Math.max(0, mount.heightMetres() - BEAM_BELOW);
    }

    /** Whether a hand pushes the sensor. */
    boolean pushed() {
        return pushed;
    }

    void setPushed(boolean byHand) {
        pushed = byHand;
    }
}
