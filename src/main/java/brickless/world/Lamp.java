package brickless.world;

/** A light source: {@code lux} is the illuminance on the floor right below it. */
public record Lamp(String id, double lux, Point2 position) {}
