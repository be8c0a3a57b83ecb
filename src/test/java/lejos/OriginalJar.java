package lejos;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.MalformedURLException;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;

/** The published leJOS EV3 0.9.1 jar, for comparison: its path, and its classes in a loader of their own. */
public final class OriginalJar {
    private OriginalJar() {}

    /** Path of the jar, from the system property {@code brickless.oracle}. */
    public static Path path() {
        String property = System.getProperty("brickless.oracle");
        if (property == null) {
            throw new AssertionError(
                    "system property brickless.oracle must name the published lejos-ev3-api-0.9.1-beta.jar");
        }
        Path jar = Path.of(property);
        if (!Files.isRegularFile(jar)) {
            throw new AssertionError("system property brickless.oracle names no file: " + jar);
        }
        return jar;
    }

    /** A new loader of the published classes, which sees nothing of ours. */
    public static URLClassLoader loader() {
        return new URLClassLoader(new URL[] {url(path())}, ClassLoader.getPlatformClassLoader());
    }

    /**
     * A new loader of the published classes together with classes of this test tree, so that one driver compiled
     * against our classes runs against the published ones.
     *
     * @param driver a class of the test tree; it and its neighbours are defined anew in the loader
     */
    public static URLClassLoader loaderWith(Class<?> driver) {
        return new URLClassLoader(new URL[] {url(path()), url(testClasses(driver))},
                ClassLoader.getPlatformClassLoader());
    }

    /** Where a class of the test tree was found. */
    static Path testClasses(Class<?> driver) {
        try {
            return Path.of(driver.getProtectionDomain().getCodeSource().getLocation().toURI());
        } catch (URISyntaxException e) {
            throw new AssertionError(e);
        }
    }

    /** Runs a static method without parameters of a driver class against the published classes. */
    public static Object run(Class<?> driver, String method, Object... arguments) {
        try (URLClassLoader loader = loaderWith(driver)) {
            Class<?> twin = loader.loadClass(driver.getName());
            for (var candidate : twin.getDeclaredMethods()) {
                if (candidate.getName().equals(method)) {
                    candidate.setAccessible(true);
                    return candidate.invoke(null, arguments);
                }
            }
            throw new AssertionError("no method " + method + " in " + driver);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError("the published jar failed in " + driver.getSimpleName() + "." + method, e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static URL url(Path path) {
        try {
            return path.toUri().toURL();
        } catch (MalformedURLException e) {
            throw new AssertionError(e);
        }
    }
}
