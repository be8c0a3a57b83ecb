package brickless.loading;

/**
 * Questions about JDK classes, and ours that stand for some, answered by the running JDK without initialising them.
 * Names are internal.
 */
final class JdkTypes {
    private static final String OURS = "brickless/";

    private JdkTypes() {}

    /** Whether a JDK class is, extends or implements another; false for classes that this JDK does not have. */
    static boolean isSubtype(String name, String ancestor) {
        if (name.equals(ancestor)) {
            return true;
        }
        Class<?> type = find(name);
        Class<?> other = find(ancestor);
        return type != null && other != null && other.isAssignableFrom(type);
    }

    /**
     * Whether instances of a class that extends this JDK class have no hash code of their own, unless they declare one.
     */
    static boolean hasIdentityHash(String name) {
        Class<?> type = find(name);
        try {
            return type != null && type.getMethod("hashCode").getDeclaringClass() == Object.class;
        } catch (NoSuchMethodException impossible) {
            throw new LinkageError(name, impossible);
        }
    }

    private static Class<?> find(String name) {
        ClassLoader loader = name.startsWith(OURS) ? JdkTypes.class.getClassLoader()
                : ClassLoader.getPlatformClassLoader();
        try {
            return Class.forName(name.replace('/', '.'), false, loader);
        } catch (ClassNotFoundException absent) {
            return null;
        }
    }
}
