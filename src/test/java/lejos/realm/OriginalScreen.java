package lejos.realm;

import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.util.function.IntFunction;
import lejos.OriginalJar;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.commons.ClassRemapper;
import org.objectweb.asm.commons.SimpleRemapper;

/** The published classes with a display manager that needs no device, and a driver of the test tree that uses them. */
public final class OriginalScreen extends URLClassLoader {
    private static final String MANAGER = "lejos/internal/ev3/EV3LCDManager";
    private static final String STAND_IN = "lejos/realm/LayersWithoutDevice";

    private OriginalScreen(URL[] places) {
        super(places, ClassLoader.getPlatformClassLoader());
    }

    /** Links a driver class with the published classes; the function calls its {@code play(int)}. */
    public static IntFunction<Object> linked(Class<?> driver) {
        try {
            OriginalScreen loader = new OriginalScreen(new URL[] {
                OriginalJar.path().toUri().toURL(), driver.getProtectionDomain().getCodeSource().getLocation()
            });
            Method play = loader.loadClass(driver.getName()).getDeclaredMethod("play", int.class);
            play.setAccessible(true);
            return index -> call(play, index);
        } catch (ReflectiveOperationException | IOException e) {
            throw new AssertionError(e);
        }
    }

    private static Object call(Method play, int index) {
        try {
            return play.invoke(null, index);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError("the published classes failed for index " + index, e);
        }
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        if (!name.replace('.', '/').equals(MANAGER)) {
            return super.findClass(name);
        }
        try (InputStream code = getResourceAsStream(STAND_IN + ".class")) {
            ClassWriter writer = new ClassWriter(0);
            new ClassReader(code)
                    .accept(new ClassRemapper(writer, new SimpleRemapper(Opcodes.ASM9, STAND_IN, MANAGER)), 0);
            byte[] renamed = writer.toByteArray();
            return defineClass(name, renamed, 0, renamed.length);
        } catch (IOException e) {
            throw new ClassNotFoundException(name, e);
        }
    }
}
