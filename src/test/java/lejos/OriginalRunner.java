package lejos;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Method;
import java.net.URLClassLoader;
import java.util.Map;

/** Calls a driver's static method again and again against the published classes. */
final class OriginalRunner implements AutoCloseable {
    private final URLClassLoader loader;
    private final Method method;

    OriginalRunner(Class<?> driver, String name) {
        try {
            loader = OriginalJar.loaderWith(driver);
            method = loader.loadClass(driver.getName()).getDeclaredMethod(name, int.class);
            method.setAccessible(true);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }

    @SuppressWarnings("unchecked")
    Map<String, Double> run(int index) {
        try {
            return (Map<String, Double>) method.invoke(null, index);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError("the published classes failed for index " + index, e);
        }
    }

    @Override
    public void close() {
        try {
            loader.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
