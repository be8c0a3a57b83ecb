package lejos.robotics;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** A motor of any interface that notes its calls and answers what a test says. */
final class MotorLog {
    private final List<String> calls = new ArrayList<>();
    private final Map<String, Object> answers;

    MotorLog(Map<String, Object> answers) {
        this.answers = answers;
    }

    List<String> calls() {
        return calls;
    }

    <T> T as(Class<T> type) {
        return type.cast(Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[] {type}, this::call));
    }

    private Object call(Object self, Method method, Object[] arguments) {
        calls.add(method.getName() + (arguments == null ? "[]" : Arrays.toString(arguments)));
        Class<?> result = method.getReturnType();
        Object absent = result == int.class ? 0 : result == boolean.class ? false : result == float.class ? 0f : null;
        return answers.getOrDefault(method.getName(), absent);
    }
}
