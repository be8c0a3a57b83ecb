package lejos;

import japicmp.model.AccessModifier;
import japicmp.model.JApiBehavior;
import japicmp.model.JApiChangeStatus;
import japicmp.model.JApiClass;
import japicmp.model.JApiCompatibility;
import japicmp.model.JApiCompatibilityChangeType;
import japicmp.model.JApiConstructor;
import japicmp.model.JApiField;
import japicmp.model.JApiHasAccessModifier;
import japicmp.model.JApiHasModifiers;
import japicmp.model.JApiMethod;
import japicmp.model.JApiModifier;
import japicmp.model.JApiParameter;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/** One difference between a published class and ours. */
record SignatureDifference(String where, String what) {
    private static final String ADDED = "added";

    /** All differences of a class and its members. */
    static List<SignatureDifference> of(JApiClass type) {
        List<SignatureDifference> found = new ArrayList<>();
        String name = type.getFullyQualifiedName();
        inspect(found, name, type, type, type);
        if (type.getSuperclass().getChangeStatus() != JApiChangeStatus.UNCHANGED) {
            found.add(new SignatureDifference(name, "superclass " + type.getSuperclass().getOldSuperclassName()
                    .orElse("none") + " became " + type.getSuperclass().getNewSuperclassName().orElse("none")));
        }
        type.getInterfaces().stream().filter(i -> i.getChangeStatus() != JApiChangeStatus.UNCHANGED)
                .forEach(
                i -> found.add(new SignatureDifference(name, i.getChangeStatus() + " " + i.getFullyQualifiedName())));
        for (JApiField field : type.getFields()) {
            inspect(found, name + "." + field.getName(), field, field, field);
            compareConstants(found, name + "." + field.getName(), field);
        }
        for (JApiConstructor constructor : type.getConstructors()) {
            inspect(found, name + "(" + parameters(constructor) + ")", constructor, constructor, constructor);
        }
        for (JApiMethod method : type.getMethods()) {
            String where = name + "." + method.getName() + "(" + parameters(method) + ")";
            inspect(found, where, method, method, method);
        }
        return found;
    }

    boolean isAddition() {
        return what.equals(ADDED);
    }

    @Override
    public String toString() {
        return isAddition() ? where : where + ": " + what;
    }

    private static void inspect(List<SignatureDifference> found, String where, JApiHasAccessModifier access,
            JApiHasModifiers modifiers, JApiCompatibility compatibility) {
        boolean before = visible(access.getAccessModifier().getOldModifier());
        boolean after = visible(access.getAccessModifier().getNewModifier());
        if (before != after) {
            found.add(new SignatureDifference(where, before ? "missing" : ADDED));
        }
        if (!before || !after) {
            return;
        }
        for (JApiModifier<?> modifier : modifiers.getModifiers()) {
            if (modifier.getChangeStatus() == JApiChangeStatus.MODIFIED) {
                found.add(new SignatureDifference(where,
                        modifier.getOldModifier().get() + " became " + modifier.getNewModifier().get()));
            }
        }
        compatibility.getCompatibilityChanges().stream().filter(c -> !concernsMembers(c.getType()))
                .forEach(c -> found.add(new SignatureDifference(where, c.getType().name())));
    }

    private static void compareConstants(List<SignatureDifference> found, String where, JApiField field) {
        if (!visible(field.getAccessModifier().getOldModifier()) || field.getNewFieldOptional().isEmpty()) {
            return;
        }
        Object before = field.getOldFieldOptional().orElseThrow().getConstantValue();
        Object after = field.getNewFieldOptional().orElseThrow().getConstantValue();
        if (!Objects.equals(before, after)) {
            found.add(new SignatureDifference(where, before + " became " + after));
        }
    }

    static boolean visible(Optional<AccessModifier> access) {
        return access.isPresent() && (access.get() == AccessModifier.PUBLIC
                || access.get() == AccessModifier.PROTECTED);
    }

    /** Changes that japicmp notes at the class but that stem from a member, which is inspected by itself. */
    private static boolean concernsMembers(JApiCompatibilityChangeType type) {
        return type.name().startsWith("METHOD_ADDED") || type.name().contains("NEW_DEFAULT")
                || type.name().startsWith("METHOD_DEFAULT_ADDED");
    }

    private static String parameters(JApiBehavior behavior) {
        return behavior.getParameters().stream().map(JApiParameter::getType).collect(Collectors.joining(", "));
    }
}
