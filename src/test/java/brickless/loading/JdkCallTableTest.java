package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.kernel.hooks.JdkCall;
import brickless.kernel.hooks.JdkCall.Kind;
import brickless.kernel.hooks.JdkCalls;
import java.lang.invoke.MethodType;
import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.objectweb.asm.Type;

/** Every line of the table names a member that this JDK has, and a hook that fits it. */
class JdkCallTableTest {
    @TestFactory
    Stream<DynamicTest> everyLineNamesAJdkMemberAndAFittingHook() {
        int jdk = Runtime.version().feature();
        return JdkCalls.all().stream().filter(call -> jdk >= call.firstJdk() && jdk <= call.lastJdk())
                .map(call -> DynamicTest.dynamicTest(call.owner() + "." + call.signature(), () -> check(call)));
    }

    private static void check(JdkCall call) throws ReflectiveOperationException {
        Class<?> owner = type(call.owner());
        Class<?>[] parameters = MethodType.fromMethodDescriptorString(call.descriptor(), null).parameterArray();
        Executable member = call.name().equals("<init>") ? owner.getConstructor(parameters)
                : owner.getDeclaredMethod(call.name(), parameters);
        if (call.kind() != Kind.ARGUMENT) {
            assertThat(Modifier.isStatic(member.getModifiers())).isEqualTo(call.kind() == Kind.STATIC);
        }
        if (call.kind() == Kind.NEW) {
            checkSuppliers(call, owner);
            return;
        }
        if (member instanceof Method) {
            assertThat(Type.getMethodDescriptor((Method) member)).isEqualTo(call.descriptor());
        }
        checkHook(call.hookOwner(), call.hookName(), call.hookDescriptor());
        if (call.kind() == Kind.ARGUMENT) {
            checkConverted(call, owner);
        }
        if (call.kind() == Kind.FINAL) {
            boolean fixed = Modifier.isFinal(member.getModifiers()) || Modifier.isFinal(owner.getModifiers());
            assertThat(fixed).as("cannot be overridden").isTrue();
        }
    }

    private static void checkConverted(JdkCall call, Class<?> owner) throws ReflectiveOperationException {
        Class<?>[] parameters = MethodType.fromMethodDescriptorString(call.convertedDescriptor(), null)
                .parameterArray();
        Executable target = call.name().equals("<init>") ? owner.getConstructor(parameters)
                : owner.getMethod(call.name(), parameters);
        assertThat(target).isNotNull();
    }

    private static void checkSuppliers(JdkCall call, Class<?> owner) throws ReflectiveOperationException {
        StringBuilder arguments = new StringBuilder(call.descriptor().substring(0, call.descriptor().indexOf(')')));
        for (String[] supplier : call.suppliers()) {
            checkHook(supplier[0], supplier[1], supplier[2]);
            arguments.append(Type.getReturnType(supplier[2]).getDescriptor());
        }
        Class<?>[] extended = MethodType.fromMethodDescriptorString(arguments + ")V", null).parameterArray();
        assertThat(owner.getConstructor(extended)).isNotNull();
    }

    private static void checkHook(String owner, String name, String descriptor) throws ReflectiveOperationException {
        ClassLoader loader = JdkCallTableTest.class.getClassLoader();
        MethodType expected = MethodType.fromMethodDescriptorString(descriptor, loader);
        Method hook = type(owner).getMethod(name, expected.parameterArray());
        assertThat(Modifier.isStatic(hook.getModifiers())).isTrue();
        assertThat(hook.getReturnType()).isEqualTo(expected.returnType());
    }

    private static Class<?> type(String internalName) throws ClassNotFoundException {
        return Class.forName(internalName.replace('/', '.'));
    }
}
