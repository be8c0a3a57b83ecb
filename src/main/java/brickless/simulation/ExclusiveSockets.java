package brickless.simulation;

import brickless.hardware.BrickHardware;
import brickless.kernel.LiveProcessor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Wraps sockets for real threads: every call holds the live processor's lock, except while it waits. Sockets that a
 * socket hands out are wrapped too, always by the same object. Thread-safe.
 */
final class ExclusiveSockets {
    private static final String SOCKETS = BrickHardware.class.getPackageName();

    private final LiveProcessor processor;
    /** Guarded by the processor's lock. */
    private final Map<Object, Object> wrapped = new IdentityHashMap<>();

    ExclusiveSockets(LiveProcessor processor) {
        this.processor = processor;
    }

    /** The socket, safe to be called by any thread. */
    <T> T wrap(Class<T> type, T socket) {
        return type.cast(wrapped(socket));
    }

    private Object wrapped(Object socket) {
        return processor.exclusively(() -> wrapped.computeIfAbsent(socket, this::proxy));
    }

    private Object proxy(Object socket) {
        Class<?>[] types = socketsOf(socket.getClass()).distinct().toArray(Class<?>[]::new);
        return Proxy.newProxyInstance(BrickHardware.class.getClassLoader(), types, (proxy, method, arguments) -> {
            Call call = new Call(socket, method, arguments);
            processor.exclusively(call);
            Object result = call.result();
            return result != null && isSocket(method.getReturnType()) ? wrapped(result) : result;
        });
    }

    /** A device may be several sockets at once. */
    private static Stream<Class<?>> socketsOf(Class<?> type) {
        Stream<Class<?>> own = Stream.of(type.getInterfaces()).filter(ExclusiveSockets::isSocket);
        return type.getSuperclass() == null ? own : Stream.concat(own, socketsOf(type.getSuperclass()));
    }

    private static boolean isSocket(Class<?> type) {
        return type.isInterface() && type.getPackageName().equals(SOCKETS);
    }

    /** One call of a socket; keeps what it returned or threw. */
    private static final class Call implements Runnable {
        private final Object socket;
        private final Method method;
        private final Object[] arguments;
        private Object result;
        private Throwable thrown;

        Call(Object socket, Method method, Object[] arguments) {
            this.socket = socket;
            this.method = method;
            this.arguments = arguments;
        }

        @Override
        public void run() {
            try {
                result = method.invoke(socket, arguments);
            } catch (InvocationTargetException e) {
                thrown = e.getCause();
            } catch (IllegalAccessException e) {
                throw new IllegalStateException("sockets are public interfaces", e);
            }
        }

        Object result() throws Throwable {
            if (thrown != null) {
                throw thrown;
            }
            return result;
        }
    }
}
