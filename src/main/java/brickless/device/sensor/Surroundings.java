package brickless.device.sensor;

import brickless.physics.Aim;
import brickless.physics.Arena;
import brickless.physics.RayHit;
import brickless.world.Lamp;

/**
 * What sensors can perceive: the arena, its floor and lights.
 *
 * <p>Guarded by the arena's monitor.
 */
public final class Surroundings {
    /** Height of all lamps, metres: assumption; decides how fast their light fades with distance. */
    private static final double LAMP_HEIGHT = 0.5;

    private final Arena arena;
    private final FloorColour floor;
    private final boolean ideal;
    private final long seed;

    /**
     * Creates the surroundings.
     *
     * @param arena with bodies
     * @param floor what is painted
     * @param seed of all noise
     * @param ideal without noise and latency
     */
    public Surroundings(Arena arena, FloorColour floor, long seed, boolean ideal) {
        this.arena = arena;
        this.floor = floor;
        this.seed = seed;
        this.ideal = ideal;
    }

    /** The arena. */
    public Arena arena() {
        return arena;
    }

    /** Whether sensors have no noise and no latency. */
    public boolean ideal() {
        return ideal;
    }

    FloorColour floor() {
        return floor;
    }

    Noise noise(String robot, int port) {
        return ideal ? Noise.NONE : Noise.of(seed, robot, port);
    }

    /** Illuminance on the floor at a point, lux. */
    double lux(double x, double y) {
        double sum = arena.description().ambientLux();
        for (Lamp lamp : arena.description().lamps()) {
            double dx = x - lamp.position().x();
            double dy = y - lamp.position().y();
            double cosSquared = LAMP_HEIGHT * LAMP_HEIGHT / (LAMP_HEIGHT * LAMP_HEIGHT + dx * dx + dy * dy);
            sum += lamp.lux() * cosSquared * cosSquared;
        }
        return sum;
    }

    /** Casts a ray, see {@link Arena#castRay}. */
    void ray(Aim aim, double turnRadians, double reachMetres, SensorSite site, RayHit out) {
        arena.castRay(aim, turnRadians, reachMetres, site.leastHeightMetres(), site.robot(), out);
    }
}
