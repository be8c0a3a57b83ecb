package brickless.loading;

import brickless.loading.ClassSummary.Initialisation;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;

/**
 * Answers questions about the classes that are rewritten for a robot, by internal name. Not thread-safe: guarded by the
 * loader's lock.
 */
final class ClassCatalog {
    private final Function<String, ClassFile> rewritable;
    private final JdkReplacements replacements;
    private final Map<String, ClassSummary> summaries = new HashMap<>();
    private Map<String, ClassSummary> consulted = new HashMap<>();

    /**
     * Creates a catalogue.
     *
     * @param rewritable finds the file of a class that is rewritten, by internal name; null for any other class
     */
    ClassCatalog(Function<String, ClassFile> rewritable, JdkReplacements replacements) {
        this.rewritable = rewritable;
        this.replacements = replacements;
    }

    /** The summary of a class that is rewritten; null for any other class. */
    ClassSummary summary(String name) {
        ClassSummary summary = summaryUnnoticed(name);
        consulted.put(name, summary);
        return summary;
    }

    private ClassSummary summaryUnnoticed(String name) {
        if (summaries.containsKey(name)) {
            return summaries.get(name);
        }
        ClassFile file = name.startsWith("[") ? null : rewritable.apply(name);
        ClassSummary summary = file == null ? null : ClassSummaryReader.read(file, name, replacements, this::isPresent);
        summaries.put(name, summary);
        return summary;
    }

    private boolean isPresent(String name) {
        return !name.startsWith("[") && rewritable.apply(name) != null;
    }

    /** Every class asked for since the last call, with the answers: what a rewriting depended on. */
    Map<String, ClassSummary> takeConsulted() {
        Map<String, ClassSummary> taken = consulted;
        consulted = new HashMap<>();
        return taken;
    }

    /** Whether the class is rewritten. */
    boolean isRewritten(String name) {
        return summary(name) != null;
    }

    /** The JDK class in which the lookup of a member ends, or null when a rewritten class on the way declares it. */
    String jdkOwner(String owner, String signature) {
        String name = owner.startsWith("[") ? "java/lang/Object" : owner;
        for (ClassSummary summary = summary(name); summary != null; summary = summary(name)) {
            if (summary.methods().contains(signature)) {
                return null;
            }
            name = summary.superName() == null ? "java/lang/Object" : summary.superName();
        }
        return name;
    }

    /**
     * The rewritten class that declares a static method or field named through {@code owner}; {@code owner} itself if
     * none does.
     */
    String declaringClass(String owner, String member, boolean method) {
        String name = owner;
        for (ClassSummary summary = summary(name); summary != null; summary = summary(name)) {
            if ((method ? summary.methods() : summary.staticFields()).contains(member)) {
                return name;
            }
            String constants = method ? null : interfaceWithConstant(summary, member);
            if (constants != null) {
                return constants;
            }
            name = summary.superName();
        }
        return owner;
    }

    private String interfaceWithConstant(ClassSummary type, String field) {
        for (String parent : type.interfaces()) {
            ClassSummary summary = summary(parent);
            if (summary != null) {
                String found = summary.staticFields().contains(field) ? parent : interfaceWithConstant(summary, field);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    /** Whether {@code ancestor} is a proper superclass of {@code name}. */
    boolean isSuperclass(String ancestor, String name) {
        ClassSummary summary = summary(name);
        while (summary != null && summary.superName() != null) {
            if (summary.superName().equals(ancestor)) {
                return true;
            }
            summary = summary(summary.superName());
        }
        return false;
    }

    /** Whether uses of the class must trigger its initialisation on a fibre. */
    boolean initialisesOnFibre(String name) {
        ClassSummary summary = summary(name);
        if (summary == null || summary.isInterface()) {
            return false;
        }
        return summary.initialisation() == Initialisation.MAY_BLOCK || isGuarded(name)
                || initialisesOnFibre(summary.superName());
    }

    /**
     * Whether uses of a class or interface must ask for its initialisation before they touch it: it is an interface
     * whose initialiser may block, which must stay the JVM's, or a class with which the JVM initialises such a one.
     */
    boolean isGuarded(String name) {
        ClassSummary summary = summary(name);
        if (summary == null) {
            return false;
        }
        if (summary.isInterface()) {
            return summary.initialisation() == Initialisation.MAY_BLOCK;
        }
        return isGuarded(summary.superName()) || implementsGuarded(summary);
    }

    private boolean implementsGuarded(ClassSummary type) {
        for (String parent : type.interfaces()) {
            ClassSummary summary = summary(parent);
            if (summary != null
                    && (summary.hasDefaultMethods() && isGuarded(parent) || implementsGuarded(summary))) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether the class's own static initialiser is run on a fibre: it may block, or must wait for a superclass that
     * may.
     */
    boolean ownInitialiserOnFibre(String name) {
        return initialisesOnFibre(name) && summary(name).initialisation() != Initialisation.NONE;
    }

    /** Whether it is an enum type (not the class of a constant with a body). */
    boolean isEnum(String name) {
        return "java/lang/Enum".equals(summary(name).superName());
    }
}
