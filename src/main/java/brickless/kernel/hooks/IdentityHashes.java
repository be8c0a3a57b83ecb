package brickless.kernel.hooks;

import java.lang.ref.Reference;
import java.lang.ref.ReferenceQueue;
import java.lang.ref.WeakReference;
import java.util.HashMap;
import java.util.Map;

/**
 * Sequential identity hashes: the host's differ from run to run. Objects of the program keep theirs; an instance of
 * this class keeps those of all others for one robot. Per robot.
 */
public final class IdentityHashes {
    private static final Map<Class<?>, Boolean> WITHOUT_OWN_HASH = new HashMap<>();
    private final Map<Object, Integer> ofJdkObjects = new HashMap<>();
    private final ReferenceQueue<Object> collected = new ReferenceQueue<>();

    IdentityHashes() {}

    /** The hash that a program object keeps: {@code drawn} if it has one, else the next. */
    public static int orNext(int drawn) {
        return drawn != 0 ? drawn : Hooks.machine().nextIdentityHash();
    }

    /** {@code System.identityHashCode(object)}. */
    public static int identityHashCode(Object object) {
        if (object == null) {
            return 0;
        }
        return object instanceof IdentityHashed ? ((IdentityHashed) object).bricklessIdentityHash()
                : Hooks.robot().identityHashes.ofJdkObject(object);
    }

    /** {@code object.hashCode()}, where that would be the host's identity hash: a sequential one. */
    public static int hashCode(Object object) {
        if (object instanceof Enum) {
            return ((Enum<?>) object).name().hashCode();
        }
        if (object instanceof Class) {
            return ((Class<?>) object).getName().hashCode();
        }
        if (object instanceof IdentityHashed || !hasIdentityHash(object.getClass())) {
            return object.hashCode();
        }
        return Hooks.robot().identityHashes.ofJdkObject(object);
    }

    /** {@code Objects.hashCode(object)}. */
    public static int hashCodeOrZero(Object object) {
        return object == null ? 0 : hashCode(object);
    }

    /** {@code Objects.hash(values)} and {@code Arrays.hashCode(values)}. */
    public static int hash(Object[] values) {
        if (values == null) {
            return 0;
        }
        int result = 1;
        for (Object value : values) {
            result = 31 * result + hashCodeOrZero(value);
        }
        return result;
    }

    /** Whether {@code object.hashCode()} would give what the host drew. */
    static boolean isHosts(Object object) {
        return object instanceof Enum || object instanceof Class
                || !(object instanceof IdentityHashed) && hasIdentityHash(object.getClass());
    }

    private static synchronized boolean hasIdentityHash(Class<?> type) {
        return WITHOUT_OWN_HASH.computeIfAbsent(type, IdentityHashes::inheritsObjectHash);
    }

    /** Program classes that have none implement {@link IdentityHashed}; lambdas and JDK classes are asked. */
    private static boolean inheritsObjectHash(Class<?> type) {
        if (type.getClassLoader() == IdentityHashes.class.getClassLoader() && !type.isHidden()) {
            return false;
        }
        try {
            return type.getMethod("hashCode").getDeclaringClass() == Object.class;
        } catch (NoSuchMethodException impossible) {
            throw new LinkageError(type.getName(), impossible);
        }
    }

    private synchronized int ofJdkObject(Object object) {
        for (Reference<?> gone = collected.poll(); gone != null; gone = collected.poll()) {
            ofJdkObjects.remove(gone);
        }
        return ofJdkObjects.computeIfAbsent(new WeakIdentity(object, collected),
                key -> Hooks.machine().nextIdentityHash());
    }

    private static final class WeakIdentity extends WeakReference<Object> {
        private final int hash;

        WeakIdentity(Object object, ReferenceQueue<Object> queue) {
            super(object, queue);
            hash = System.identityHashCode(object);
        }

        @Override
        public int hashCode() {
            return hash;
        }

        @Override
        public boolean equals(Object other) {
            return this == other
                    || other instanceof WeakIdentity && get() != null && ((WeakIdentity) other).get() == get();
        }
    }
}
