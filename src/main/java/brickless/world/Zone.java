package brickless.world;

/** A named area for goals and tests; neither seen nor felt. */
public record Zone(String name, Region region) {}
