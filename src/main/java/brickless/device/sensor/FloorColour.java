package brickless.device.sensor;

import brickless.world.Floor;
import brickless.world.World;

/** What a colour sensor looks down on. */
@FunctionalInterface
public interface FloorColour {
    /**
     * Colour of a point as drawn.
     *
     * @return sRGB as {@code 0xRRGGBB}, or −1 where there is no floor
     */
    int at(double xMetres, double yMetres);

    /** The floor of a world: paint upon white, nothing outside the table. */
    static FloorColour of(World world) {
        Floor floor = new Floor(world);
        return floor::rgbAt;
    }
}
