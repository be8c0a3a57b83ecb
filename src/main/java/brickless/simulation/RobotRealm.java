package brickless.simulation;

import brickless.hardware.BrickAccess;
import brickless.hardware.BrickHardware;
import brickless.kernel.Kernel;
import brickless.loading.LoadingRules;
import brickless.loading.RobotClassLoader;
import brickless.program.Program;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Optional;

/** The classes of one robot: loads its program, attaches the brick, and gives the kernel its main thread. */
final class RobotRealm {
    /** Starts programs inside the robot's realm as the brick's menu does. */
    private static final String LAUNCHER = "lejos.internal.ev3.EV3Wrapper";

    private final RobotClassLoader loader;
    private final Kernel kernel;

    RobotRealm(Program program, Kernel kernel, BrickHardware brick, Optional<ProgramBody> body) {
        this.kernel = kernel;
        try {
            loader = program.classPath().isEmpty()
                    ? RobotClassLoader.ofApplication(Thread.currentThread().getContextClassLoader(), LoadingRules.standard())
                    : RobotClassLoader.ofPaths(program.classPath());
        } catch (IOException e) {
            throw new SetupException(e.getMessage());
        }
        kernel.bind(loader.bind(kernel));
        attach(brick);
        Thread main = body.isPresent() ? loader.programThread("main", () -> run(body.get())) : loader.mainThread(LAUNCHER, program.mainClass());
        main.setContextClassLoader(loader);
        kernel.main(main, main);
    }

    private void run(ProgramBody body) {
        try {
            Class<?> launcher = loader.initialized(LAUNCHER);
            MethodHandles.publicLookup().findStatic(launcher, "prepare", MethodType.methodType(void.class)).invoke();
            body.run(loader);
        } catch (Throwable thrown) {
            throw RobotRealm.<RuntimeException>unchecked(thrown);
        }
    }

    /** Throws an exception of the program as it is. */
    @SuppressWarnings("unchecked")
    private static <E extends Throwable> E unchecked(Throwable failure) throws E {
        throw (E) failure;
    }

    private void attach(BrickHardware brick) {
        try {
            loader.loadClass(BrickAccess.class.getName()).getMethod("attach", BrickHardware.class).invoke(null, brick);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("the robot's own BrickAccess must be there", e);
        }
    }

    /** Ends the program from outside, e.g. within a physics step, on a thread of its own: shutdown hooks still run. */
    void end(int status) {
        kernel.start(loader.programThread("menu", () -> kernel.exit(status)));
    }

    /** Lets go of the program: disconnects kernel and brick and closes its jars. */
    void release() {
        attach(null);
        loader.bind(null);
        try {
            loader.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
