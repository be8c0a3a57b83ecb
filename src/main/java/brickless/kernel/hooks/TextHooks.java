package brickless.kernel.hooks;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.AbstractCollection;
import java.util.AbstractMap;
import java.util.Collection;
import java.util.Date;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.StringJoiner;

/** Conversions to text in rewritten code, free of anything that differs between hosts and JDKs. Per robot. */
public final class TextHooks {
    private static final Map<Class<?>, Boolean> COLLECTIONS_WITH_JDK_TEXT = new IdentityHashMap<>();

    private TextHooks() {}

    /** {@code String.valueOf(value)} and everything that means the same. */
    public static String text(Object value) {
        return value == null ? "null" : toString(value);
    }

    /** {@code Double.toString(value)}. */
    public static String text(double value) {
        return FloatingText.of(value);
    }

    /** {@code Float.toString(value)}. */
    public static String text(float value) {
        return FloatingText.of(value);
    }

    /** {@code value.toString()}. */
    public static String toString(Object value) {
        if (value instanceof String) {
            return (String) value;
        }
        if (value instanceof Double) {
            return FloatingText.of((Double) value);
        }
        if (value instanceof Float) {
            return FloatingText.of((Float) value);
        }
        if (value instanceof Throwable) {
            return ThrowableText.summary((Throwable) value);
        }
        if (value.getClass() == Date.class) {
            return TimeHooks.text((Date) value);
        }
        if (value.getClass() == ByteArrayOutputStream.class) {
            return ((ByteArrayOutputStream) value).toString(StandardCharsets.UTF_8);
        }
        if (value.getClass() == Object.class || value.getClass().isArray()) {
            return value.getClass().getName() + "@" + Integer.toHexString(IdentityHashes.hashCode(value));
        }
        return isJdkCollection(value) ? collectionText(value) : value.toString();
    }

    /** {@code Objects.toString(value, otherwise)}. */
    public static String text(Object value, String otherwise) {
        return value == null ? otherwise : toString(value);
    }

    /** {@code Arrays.toString(values)}. */
    public static String arrayText(double[] values) {
        if (values == null) {
            return "null";
        }
        StringJoiner joiner = new StringJoiner(", ", "[", "]");
        for (double value : values) {
            joiner.add(FloatingText.of(value));
        }
        return joiner.toString();
    }

    /** {@code Arrays.toString(values)}. */
    public static String arrayText(float[] values) {
        if (values == null) {
            return "null";
        }
        StringJoiner joiner = new StringJoiner(", ", "[", "]");
        for (float value : values) {
            joiner.add(FloatingText.of(value));
        }
        return joiner.toString();
    }

    /** {@code Arrays.toString(values)}. */
    public static String arrayText(Object[] values) {
        if (values == null) {
            return "null";
        }
        StringJoiner joiner = new StringJoiner(", ", "[", "]");
        for (Object value : values) {
            joiner.add(text(value));
        }
        return joiner.toString();
    }

    private static boolean isJdkCollection(Object value) {
        if (!(value instanceof AbstractCollection) && !(value instanceof AbstractMap)) {
            return false;
        }
        synchronized (COLLECTIONS_WITH_JDK_TEXT) {
            return COLLECTIONS_WITH_JDK_TEXT.computeIfAbsent(value.getClass(), TextHooks::hasJdkText);
        }
    }

    private static boolean hasJdkText(Class<?> type) {
        if (type.getClassLoader() != null && !type.getName().startsWith("brickless.")) {
            return false;
        }
        try {
            Class<?> owner = type.getMethod("toString").getDeclaringClass();
            return owner == AbstractCollection.class || owner == AbstractMap.class;
        } catch (NoSuchMethodException impossible) {
            throw new LinkageError(type.getName(), impossible);
        }
    }

    private static String collectionText(Object value) {
        if (value instanceof Collection) {
            StringJoiner joiner = new StringJoiner(", ", "[", "]");
            for (Iterator<?> elements = ((Collection<?>) value).iterator(); elements.hasNext();) {
                Object element = elements.next();
                joiner.add(element == value ? "(this Collection)" : text(element));
            }
            return joiner.toString();
        }
        StringJoiner joiner = new StringJoiner(", ", "{", "}");
        for (Map.Entry<?, ?> entry : ((Map<?, ?>) value).entrySet()) {
            joiner.add(mapPart(value, entry.getKey()) + "=" + mapPart(value, entry.getValue()));
        }
        return joiner.toString();
    }

    private static String mapPart(Object map, Object part) {
        return part == map ? "(this Map)" : text(part);
    }
}
