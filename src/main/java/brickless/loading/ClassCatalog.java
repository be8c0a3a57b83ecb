package brickless.loading;

import brickless.loading.ClassSummary.Initialisation;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
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

    /** Whether uses of the class or interface must trigger an initialisation first: its own or that of parents. */
    boolean initialises(String name) {
        ClassSummary summary = summary(name);
        return summary != null && (summary.initialisation() != Initialisation.NONE
                || !parentsToInitialise(name).isEmpty());
    }

    /**
     * What is initialised before a class itself: its superclass, and interfaces with default methods. An interface's
     * parents are not.
     */
    List<String> parentsToInitialise(String name) {
        ClassSummary summary = summary(name);
        List<String> parents = new ArrayList<>();
        if (summary != null && !summary.isInterface()) {
            if (initialises(summary.superName())) {
                parents.add(summary.superName());
            }
            addInterfaces(summary, parents);
        }
        return parents;
    }

    private void addInterfaces(ClassSummary type, List<String> parents) {
        for (String parent : type.interfaces()) {
            ClassSummary summary = summary(parent);
            if (summary != null) {
                addInterfaces(summary, parents);
                if (summary.hasDefaultMethods() && initialises(parent) && !parents.contains(parent)) {
                    parents.add(parent);
                }
            }
        }
    }

    /** Whether the initialisation of a class or interface may block, by its own initialiser or those of parents. */
    boolean mayBlock(String name) {
        ClassSummary summary = summary(name);
        return summary != null && (summary.initialisation() == Initialisation.MAY_BLOCK
                || parentsToInitialise(name).stream().anyMatch(this::mayBlock));
    }

    /** Whether it is an interface with a static field of that name that an initialiser sets. */
    boolean isComputedInInterface(String name, String field) {
        ClassSummary summary = summary(name);
        return summary != null && summary.isInterface() && summary.computedFields().contains(field);
    }

    /** Whether it is an interface. */
    boolean isInterface(String name) {
        ClassSummary summary = summary(name);
        return summary != null && summary.isInterface();
    }

    /** Whether it is an enum type (not the class of a constant with a body). */
    boolean isEnum(String name) {
        return "java/lang/Enum".equals(summary(name).superName());
    }
}
