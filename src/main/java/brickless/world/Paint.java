package brickless.world;

import java.util.Optional;

/**
 * One painted shape of the floor.
 *
 * @param id element id, or a generated one
 * @param region what it covers
 * @param colour its colour
 * @param opacity 0 (invisible) to 1
 * @param texture for an image: its pixels, which then replace {@code colour}
 */
public record Paint(String id, Region region, Rgb colour, double opacity, Optional<Texture> texture) {
    /** A shape of one colour. */
    public Paint(String id, Region region, Rgb colour, double opacity) {
        this(id, region, colour, opacity, Optional.empty());
    }
}
