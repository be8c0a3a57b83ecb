package brickless.kernel.hooks;

import java.lang.invoke.CallSite;
import java.lang.invoke.ConstantCallSite;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.invoke.StringConcatException;
import java.lang.invoke.StringConcatFactory;

/**
 * Bootstrap methods for {@code "a" + b} in rewritten code: the JDK's, with arguments whose text differs between JDKs
 * converted first. Per robot.
 */
public final class ConcatHooks {
    private static final MethodHandle OBJECT = converter(Object.class);
    private static final MethodHandle DOUBLE = converter(double.class);
    private static final MethodHandle FLOAT = converter(float.class);

    private ConcatHooks() {}

    /** Like {@link StringConcatFactory#makeConcat}. */
    public static CallSite makeConcat(MethodHandles.Lookup lookup, String name, MethodType type)
            throws StringConcatException {
        return converting(StringConcatFactory.makeConcat(lookup, name, converted(type)), type);
    }

    /** Like {@link StringConcatFactory#makeConcatWithConstants}. */
    public static CallSite makeConcatWithConstants(MethodHandles.Lookup lookup, String name, MethodType type,
            String recipe,
            Object... constants) throws StringConcatException {
        return converting(StringConcatFactory.makeConcatWithConstants(lookup, name, converted(type), recipe,
                constants), type);
    }

    private static MethodHandle converter(Class<?> argument) {
        try {
            return MethodHandles.lookup().findStatic(TextHooks.class, "text",
                    MethodType.methodType(String.class, argument));
        } catch (ReflectiveOperationException broken) {
            throw new ExceptionInInitializerError(broken);
        }
    }

    private static MethodType converted(MethodType type) {
        MethodType result = type;
        for (int i = 0; i < type.parameterCount(); i++) {
            if (converterFor(type.parameterType(i)) != null) {
                result = result.changeParameterType(i, String.class);
            }
        }
        return result;
    }

    private static CallSite converting(CallSite site, MethodType type) {
        MethodHandle target = site.getTarget();
        for (int i = 0; i < type.parameterCount(); i++) {
            MethodHandle converter = converterFor(type.parameterType(i));
            if (converter != null) {
                MethodHandle exact = converter.asType(MethodType.methodType(String.class, type.parameterType(i)));
                target = MethodHandles.filterArguments(target, i, exact);
            }
        }
        return new ConstantCallSite(target);
    }

    private static MethodHandle converterFor(Class<?> argument) {
        if (argument == double.class) {
            return DOUBLE;
        }
        if (argument == float.class) {
            return FLOAT;
        }
        boolean mayHoldJdkValue = argument.isInterface() || argument.isArray() || argument.getClassLoader() == null;
        return argument.isPrimitive() || argument == String.class || !mayHoldJdkValue ? null : OBJECT;
    }
}
