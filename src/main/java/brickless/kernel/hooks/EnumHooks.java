package brickless.kernel.hooks;

import java.lang.invoke.MethodType;
import java.util.HashMap;
import java.util.Map;

/** {@code Enum.valueOf} of rewritten code: the JDK would remember the constants of one robot for all. Per robot. */
public final class EnumHooks {
    private EnumHooks() {}

    /** {@code Enum.valueOf(type, name)}. */
    public static Enum<?> valueOf(Class<?> type, String name) {
        if (type.getClassLoader() != EnumHooks.class.getClassLoader() || !type.isEnum()) {
            return ofJdk(type, name);
        }
        Map<Class<?>, Map<String, Enum<?>>> known = Hooks.robot().enums;
        Map<String, Enum<?>> constants = known.get(type);
        if (constants == null) {
            constants = constantsOf(type);
            known.put(type, constants);
        }
        Enum<?> constant = constants.get(name);
        if (constant != null) {
            return constant;
        }
        if (name == null) {
            throw new NullPointerException("Name is null");
        }
        throw new IllegalArgumentException("No enum constant " + type.getCanonicalName() + "." + name);
    }

    @SuppressWarnings({"unchecked", "rawtypes"})
    private static Enum<?> ofJdk(Class<?> type, String name) {
        return Enum.valueOf((Class) type, name);
    }

    private static Map<String, Enum<?>> constantsOf(Class<?> type) {
        Map<String, Enum<?>> constants = new HashMap<>();
        for (Enum<?> constant : values(type)) {
            constants.put(constant.name(), constant);
        }
        return constants;
    }

    private static Enum<?>[] values(Class<?> type) {
        try {
            return (Enum<?>[]) ReflectionHooks.insideOf(type)
                    .findStatic(type, "values", MethodType.methodType(type.arrayType())).invoke();
        } catch (Throwable failure) {
            throw ReflectionHooks.<RuntimeException>unchecked(failure);
        }
    }
}
