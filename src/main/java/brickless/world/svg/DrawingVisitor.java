package brickless.world.svg;

import brickless.world.DescriptionException;

/** Receives a drawing from the walker. Malformed values are reported at the element that is being visited. */
interface DrawingVisitor {
    /**
     * Called before a group, {@code use} or shape is looked into.
     *
     * @return true if the visitor has dealt with the whole element
     */
    boolean enter(SvgElement element, Scope scope) throws DescriptionException, MalformedValueException;

    /** Called for every shape that is displayed and visible. */
    void shape(DrawnShape shape) throws DescriptionException, MalformedValueException;
}
