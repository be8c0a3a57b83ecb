package brickless.hardware.fake;

import brickless.hardware.BrickHardware;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;

/**
 * Defines {@code lejos} classes and one program class anew, so that a test can see their static state as a fresh
 * program does.
 */
public final class RobotRealm extends ClassLoader {
    private static final String BRICK_ACCESS = "brickless.hardware.BrickAccess";

    private final String program;

    private RobotRealm(String program) {
        super(RobotRealm.class.getClassLoader());
        this.program = program;
    }

    /**
     * Runs a program in a realm of its own.
     *
     * @param brick the brick it runs on
     * @param program a class with a public constructor without parameters
     */
    public static void run(BrickHardware brick, Class<? extends Runnable> program) {
        RobotRealm realm = new RobotRealm(program.getName());
        try {
            realm.loadClass(BRICK_ACCESS).getMethod("attach", BrickHardware.class).invoke(null, brick);
            ((Runnable) realm.loadClass(program.getName()).getConstructor().newInstance()).run();
        } catch (InvocationTargetException e) {
            throw new AssertionError(e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        boolean own = name.startsWith("lejos.") || name.equals(BRICK_ACCESS) || name.startsWith(program);
        if (!own) {
            return super.loadClass(name, resolve);
        }
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            return loaded != null ? loaded : define(name);
        }
    }

    private Class<?> define(String name) throws ClassNotFoundException {
        try (InputStream code = getParent().getResourceAsStream(name.replace('.', '/') + ".class")) {
            if (code == null) {
                throw new ClassNotFoundException(name);
            }
            byte[] bytes = code.readAllBytes();
            return defineClass(name, bytes, 0, bytes.length);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
