package brickless.world.svg;

import brickless.world.Rgb;

/** A paint colour with its own opacity, 0 to 1. */
record Colour(Rgb rgb, double opacity) {
    static final Colour BLACK = opaque(0, 0, 0);

    static Colour opaque(int red, int green, int blue) {
        return new Colour(new Rgb(red, green, blue), 1);
    }
}
