package brickless.world.svg;

import java.util.List;
import java.util.Optional;

/**
 * The style of an element after inheritance.
 *
 * @param fill colour inside, if any
 * @param stroke colour of the line, if any
 * @param opacity product of the {@code opacity} of the element and its groups
 * @param colour what {@code currentColor} means
 * @param displayed false under {@code display: none}
 * @param visible false under {@code visibility: hidden}
 * @param clipped {@code clip-path} or {@code mask} in force here
 */
record Style(Optional<Colour> fill, Optional<Colour> stroke, double fillOpacity, double strokeOpacity, double opacity,
        boolean evenOdd, StrokeStyle line, Colour colour, boolean displayed, boolean visible, boolean clipped) {
    static final Style INITIAL = new Style(Optional.of(Colour.BLACK), Optional.empty(), 1, 1, 1, false,
            StrokeStyle.INITIAL, Colour.BLACK, true, true, false);

    /**
     * How a line is drawn, lengths in user units.
     *
     * @param dashes alternating line and gap lengths, even in number; empty for a solid line
     * @param fixedWidth whether the width ignores transforms ({@code vector-effect: non-scaling-stroke})
     */
    record StrokeStyle(double width, String cap, String join, double miterLimit, List<Double> dashes, double dashOffset,
            boolean fixedWidth) {
        static final StrokeStyle INITIAL = new StrokeStyle(1, "butt", "miter", 4, List.of(), 0, false);
    }
}
