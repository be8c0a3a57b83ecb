package lejos.realm;

import brickless.device.panel.PanelBench;
import brickless.hardware.BrickHardware;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.InvocationInterceptor;
import org.junit.jupiter.api.extension.ReflectiveInvocationContext;

/**
 * Runs each test method in a class loader of its own, on a fresh {@link PanelBench}, with {@code Thread.sleep} and the
 * clocks replaced by the bench's, which the test finds in its field of that type. So static state of {@code lejos}
 * never leaks, and timing is exact. The test code must not start threads.
 */
public final class OnPanel implements InvocationInterceptor {
    @Override
    public void interceptTestMethod(Invocation<Void> invocation, ReflectiveInvocationContext<Method> called,
            ExtensionContext context)
            throws Throwable {
        invocation.skip();
        RealmLoader realm = new RealmLoader(getClass().getClassLoader());
        PanelBench bench = new PanelBench();
        Class<?> access = realm.loadClass("brickless.hardware.BrickAccess");
        access.getMethod("attach", BrickHardware.class).invoke(null, bench);
        Class<?> twin = realm.loadClass(called.getTargetClass().getName());
        var constructor = twin.getDeclaredConstructor();
        constructor.setAccessible(true);
        Method method = twin.getDeclaredMethod(called.getExecutable().getName());
        method.setAccessible(true);
        try {
            Object test = constructor.newInstance();
            hand(bench, test);
            method.invoke(test);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    private static void hand(PanelBench bench, Object test) throws IllegalAccessException {
        for (Field field : test.getClass().getDeclaredFields()) {
            if (field.getType() == PanelBench.class) {
                field.setAccessible(true);
                field.set(test, bench);
            }
        }
    }
}
