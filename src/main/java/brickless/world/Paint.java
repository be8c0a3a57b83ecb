package brickless.world;

/**
 * One painted shape of the floor.
 *
 * @param id element id, or a generated one
 * @param region what it covers
 * @param colour its colour
 * @param opacity 0 (invisible) to 1
 */
public record Paint(String id, Region region, Rgb colour, double opacity) {}
