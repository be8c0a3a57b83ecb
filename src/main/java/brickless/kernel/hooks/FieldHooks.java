package brickless.kernel.hooks;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;

/**
 * {@code Field.get…} and {@code set…} of rewritten code: the class of a static field is initialised first, and computed
 * constants of interfaces are read where they are kept. Per robot.
 */
public final class FieldHooks {
    private FieldHooks() {}

    /** {@code field.get(receiver)}. */
    public static Object get(Field field, Object receiver) throws IllegalAccessException {
        return readable(field).get(receiver);
    }

    /** {@code field.set(receiver, value)}. */
    public static void set(Field field, Object receiver, Object value) throws IllegalAccessException {
        initialised(field).set(receiver, value);
    }

    /** {@code field.getBoolean(receiver)}. */
    public static boolean getBoolean(Field field, Object receiver) throws IllegalAccessException {
        return readable(field).getBoolean(receiver);
    }

    /** {@code field.setBoolean(receiver, value)}. */
    public static void setBoolean(Field field, Object receiver, boolean value) throws IllegalAccessException {
        initialised(field).setBoolean(receiver, value);
    }

    /** {@code field.getByte(receiver)}. */
    public static byte getByte(Field field, Object receiver) throws IllegalAccessException {
        return readable(field).getByte(receiver);
    }

    /** {@code field.setByte(receiver, value)}. */
    public static void setByte(Field field, Object receiver, byte value) throws IllegalAccessException {
        initialised(field).setByte(receiver, value);
    }

    /** {@code field.getChar(receiver)}. */
    public static char getChar(Field field, Object receiver) throws IllegalAccessException {
        return readable(field).getChar(receiver);
    }

    /** {@code field.setChar(receiver, value)}. */
    public static void setChar(Field field, Object receiver, char value) throws IllegalAccessException {
        initialised(field).setChar(receiver, value);
    }

    /** {@code field.getShort(receiver)}. */
    public static short getShort(Field field, Object receiver) throws IllegalAccessException {
        return readable(field).getShort(receiver);
    }

    /** {@code field.setShort(receiver, value)}. */
    public static void setShort(Field field, Object receiver, short value) throws IllegalAccessException {
        initialised(field).setShort(receiver, value);
    }

    /** {@code field.getInt(receiver)}. */
    public static int getInt(Field field, Object receiver) throws IllegalAccessException {
        return readable(field).getInt(receiver);
    }

    /** {@code field.setInt(receiver, value)}. */
    public static void setInt(Field field, Object receiver, int value) throws IllegalAccessException {
        initialised(field).setInt(receiver, value);
    }

    /** {@code field.getLong(receiver)}. */
    public static long getLong(Field field, Object receiver) throws IllegalAccessException {
        return readable(field).getLong(receiver);
    }

    /** {@code field.setLong(receiver, value)}. */
    public static void setLong(Field field, Object receiver, long value) throws IllegalAccessException {
        initialised(field).setLong(receiver, value);
    }

    /** {@code field.getFloat(receiver)}. */
    public static float getFloat(Field field, Object receiver) throws IllegalAccessException {
        return readable(field).getFloat(receiver);
    }

    /** {@code field.setFloat(receiver, value)}. */
    public static void setFloat(Field field, Object receiver, float value) throws IllegalAccessException {
        initialised(field).setFloat(receiver, value);
    }

    /** {@code field.getDouble(receiver)}. */
    public static double getDouble(Field field, Object receiver) throws IllegalAccessException {
        return readable(field).getDouble(receiver);
    }

    /** {@code field.setDouble(receiver, value)}. */
    public static void setDouble(Field field, Object receiver, double value) throws IllegalAccessException {
        initialised(field).setDouble(receiver, value);
    }

    /** Fields of objects need nothing: the objects could not be there otherwise. */
    private static Field initialised(Field field) {
        if (Modifier.isStatic(field.getModifiers())) {
            ClassInitialization.initializeForReflection(field.getDeclaringClass());
        }
        ReflectionHooks.makeAccessible(field, field.getDeclaringClass());
        return field;
    }

    private static Field readable(Field field) {
        Field initialised = initialised(field);
        return Modifier.isStatic(field.getModifiers()) ? ClassInitialization.storage(initialised) : initialised;
    }
}
