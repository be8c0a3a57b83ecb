package brickless.world.svg;

/**
 * What an element inherits and adds.
 *
 * @param toPage from the element's user units to millimetres on the page
 * @param style after inheritance
 * @param meaning {@code data-*} attributes in force
 */
record Scope(Affine toPage, Style style, Meaning meaning) {
    Scope moved(Affine inner) {
        return new Scope(toPage.then(inner), style, meaning);
    }
}
