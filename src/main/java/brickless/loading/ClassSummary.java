package brickless.loading;

import java.util.List;
import java.util.Set;

/**
 * What rewriting one class needs to know about another class that is rewritten too. Value equality tells the cache
 * whether it changed.
 *
 * @param superName internal name of the superclass after JDK replacements; null for none
 * @param interfaces internal names of the direct superinterfaces
 * @param isInterface whether it is an interface
 * @param hasDefaultMethods whether it is an interface that is initialised with the classes that implement it
 * @param methods name and descriptor of each declared method
 * @param staticFields names of the declared static fields
 * @param computedFields names of those that have no constant value
 * @param initialisation what its static initialiser does
 */
record ClassSummary(String superName, List<String> interfaces, boolean isInterface, boolean hasDefaultMethods,
        Set<String> methods, Set<String> staticFields, Set<String> computedFields,
        Initialisation initialisation) {
    /** What the static initialiser does. */
    enum Initialisation { NONE, HARMLESS, MAY_BLOCK }
}
