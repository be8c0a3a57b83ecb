package brickless.world.svg;

/** Sizes beyond which a drawing is refused, so that no file can exhaust memory or time. */
final class Limits {
    static final int FILE_BYTES = 32 << 20;
    static final int ELEMENTS = 50_000;
    /** Below the limit of 100 that newer JDKs set for XML, so that the complaint is ours and the same everywhere. */
    static final int NESTING = 80;
    /** Elements visited, counting each copy made by {@code use}. */
    static final int VISITS = 200_000;
    /** Points after curves are flattened, over the whole drawing. */
    static final int POINTS = 1_000_000;
    static final int IMAGE_PIXELS = 16_000_000;
    /** Coordinates and lengths, in user units. */
    static final double COORDINATE = 1e7;
    /** Greatest distance between a curve and its polygon, millimetres. */
    static final double FLATNESS_MILLIMETRES = 0.2;

    private Limits() {}
}
