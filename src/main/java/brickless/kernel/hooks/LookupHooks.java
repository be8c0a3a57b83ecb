package brickless.kernel.hooks;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles.Lookup;
import java.lang.invoke.MethodType;
import java.lang.invoke.VarHandle;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;

/**
 * Method handles that rewritten code looks up: the class is initialised when the handle is made, not when it is first
 * called, and computed constants of interfaces are found where they are kept. Per robot.
 */
public final class LookupHooks {
    private LookupHooks() {}

    /** {@code lookup.findStatic(owner, name, type)}. */
    public static MethodHandle findStatic(Lookup lookup, Class<?> owner, String name, MethodType type)
            throws NoSuchMethodException, IllegalAccessException {
        return initialised(lookup.findStatic(owner, name, type), owner);
    }

    /** {@code lookup.findConstructor(owner, type)}. */
    public static MethodHandle findConstructor(Lookup lookup, Class<?> owner, MethodType type)
            throws NoSuchMethodException, IllegalAccessException {
        return initialised(lookup.findConstructor(owner, type), owner);
    }

    /** {@code lookup.findStaticGetter(owner, name, type)}. */
    public static MethodHandle findStaticGetter(Lookup lookup, Class<?> owner, String name, Class<?> type)
            throws NoSuchFieldException, IllegalAccessException {
        MethodHandle handle = lookup.findStaticGetter(owner, name, type);
        return owner.isInterface() ? lookup.unreflectGetter(ready(owner.getField(name))) : initialised(handle, owner);
    }

    /** {@code lookup.findStaticSetter(owner, name, type)}. */
    public static MethodHandle findStaticSetter(Lookup lookup, Class<?> owner, String name, Class<?> type)
            throws NoSuchFieldException, IllegalAccessException {
        return initialised(lookup.findStaticSetter(owner, name, type), owner);
    }

    /** {@code lookup.findStaticVarHandle(owner, name, type)}. */
    public static VarHandle findStaticVarHandle(Lookup lookup, Class<?> owner, String name, Class<?> type)
            throws NoSuchFieldException, IllegalAccessException {
        VarHandle handle = lookup.findStaticVarHandle(owner, name, type);
        ClassInitialization.initializeForReflection(owner);
        return owner.isInterface() ? lookup.unreflectVarHandle(ready(owner.getField(name))) : handle;
    }

    /** {@code lookup.unreflect(method)}. */
    public static MethodHandle unreflect(Lookup lookup, Method method) throws IllegalAccessException {
        MethodHandle handle = lookup.unreflect(method);
        return Modifier.isStatic(method.getModifiers()) ? initialised(handle, method.getDeclaringClass()) : handle;
    }

    /** {@code lookup.unreflectConstructor(constructor)}. */
    public static MethodHandle unreflectConstructor(Lookup lookup, Constructor<?> constructor)
            throws IllegalAccessException {
        return initialised(lookup.unreflectConstructor(constructor), constructor.getDeclaringClass());
    }

    /** {@code lookup.unreflectGetter(field)}. */
    public static MethodHandle unreflectGetter(Lookup lookup, Field field) throws IllegalAccessException {
        return lookup.unreflectGetter(ready(field));
    }

    /** {@code lookup.unreflectSetter(field)}. */
    public static MethodHandle unreflectSetter(Lookup lookup, Field field) throws IllegalAccessException {
        MethodHandle handle = lookup.unreflectSetter(field);
        return Modifier.isStatic(field.getModifiers()) ? initialised(handle, field.getDeclaringClass()) : handle;
    }

    private static MethodHandle initialised(MethodHandle handle, Class<?> owner) {
        ClassInitialization.initializeForReflection(owner);
        return handle;
    }

    private static Field ready(Field field) {
        if (!Modifier.isStatic(field.getModifiers())) {
            return field;
        }
        ClassInitialization.initializeForReflection(field.getDeclaringClass());
        return ClassInitialization.storage(field);
    }
}
