package brickless.kernel.hooks;

import java.lang.invoke.MethodType;
import java.lang.reflect.Method;

/** Finds the hook for a JDK method that a program calls by reflection. Per robot. */
final class RedirectedMethods {
    private RedirectedMethods() {}

    /** The hook that stands for {@code method}, or null if calls of it are not redirected. */
    static Method hookFor(Method method) {
        if (method.getDeclaringClass().getClassLoader() != null) {
            return null;
        }
        String descriptor = MethodType.methodType(method.getReturnType(), method.getParameterTypes())
                .toMethodDescriptorString();
        String owner = method.getDeclaringClass().getName().replace('.', '/');
        for (JdkCall call : JdkCalls.withSignature(method.getName(), descriptor)) {
            if (call.owner().equals(owner) && isCallable(call.kind())) {
                return find(call);
            }
        }
        return null;
    }

    private static boolean isCallable(JdkCall.Kind kind) {
        return kind == JdkCall.Kind.STATIC || kind == JdkCall.Kind.VIRTUAL || kind == JdkCall.Kind.FINAL;
    }

    private static Method find(JdkCall call) {
        ClassLoader loader = RedirectedMethods.class.getClassLoader();
        try {
            Class<?>[] parameters = MethodType.fromMethodDescriptorString(call.hookDescriptor(), loader)
                    .parameterArray();
            return Class.forName(call.hookOwner().replace('/', '.'), true, loader)
                    .getMethod(call.hookName(), parameters);
        } catch (ReflectiveOperationException broken) {
            throw new LinkageError("hook of " + call, broken);
        }
    }
}
