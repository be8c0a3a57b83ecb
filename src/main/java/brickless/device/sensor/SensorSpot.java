package brickless.device.sensor;

import brickless.world.Point2;
import brickless.world.Rgb;
import java.util.Optional;

/**
 * The part of the floor that a colour or light sensor looks at now: for pictures.
 *
 * @param at its middle
 * @param radiusMetres its radius
 * @param colour its mean colour; empty while the sensor is off, or where there is no floor
 */
public record SensorSpot(Point2 at, double radiusMetres, Optional<Rgb> colour) {}
