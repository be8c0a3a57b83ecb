package brickless.loading;

import brickless.kernel.hooks.Budget;
import brickless.kernel.hooks.VirtualMachine;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** A virtual machine that notes calls and never blocks. */
final class RecordingMachine implements InvocationHandler {
    final List<String> calls = new ArrayList<>();
    final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    boolean killing;
    Runnable onBudgetExhausted = () -> { };
    Budget budget;
    private final PrintStream console = new PrintStream(printed, true, StandardCharsets.UTF_8);
    private int drawn;

    VirtualMachine machine() {
        return (VirtualMachine) Proxy.newProxyInstance(VirtualMachine.class.getClassLoader(),
                new Class<?>[] {VirtualMachine.class}, this);
    }

    @Override
    public Object invoke(Object proxy, Method method, Object[] arguments) {
        switch (method.getName()) {
            case "killing":
                return killing;
            case "currentThread":
                return Thread.currentThread();
            case "out":
            case "err":
                return console;
            case "nextIdentityHash":
            case "nextThreadNumber":
                return ++drawn;
            case "nextThreadId":
            case "nextRandomLong":
                return (long) ++drawn;
            case "budgetExhausted":
                onBudgetExhausted.run();
                return null;
            default:
                calls.add(describe(method, arguments));
                return defaultOf(method.getReturnType());
        }
    }

    private static String describe(Method method, Object[] arguments) {
        StringBuilder text = new StringBuilder(method.getName());
        for (Object argument : arguments == null ? new Object[0] : arguments) {
            boolean plain = argument instanceof Number || argument instanceof Boolean;
            text.append(' ').append(plain ? argument : argument.getClass().getSimpleName());
        }
        return text.toString();
    }

    private static Object defaultOf(Class<?> type) {
        if (type == long.class) {
            return 1234L;
        }
        return type == boolean.class ? (Object) false : null;
    }
}
