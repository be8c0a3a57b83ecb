package brickless.world;

/** An infrared beacon on channel 1 to 4. */
public record Beacon(String id, int channel, Point2 position) {}
