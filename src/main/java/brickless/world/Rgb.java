package brickless.world;

/** A colour as drawn, components 0 to 255 (sRGB). */
public record Rgb(int red, int green, int blue) {}
