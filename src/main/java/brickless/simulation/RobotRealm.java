package brickless.simulation;

import brickless.hardware.BrickAccess;
import brickless.hardware.BrickHardware;
import brickless.kernel.Kernel;
import brickless.loading.RobotClassLoader;
import brickless.loading.RobotContext;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Optional;

/** The classes of one robot: loads its program, attaches the brick, and gives the kernel its main thread. */
final class RobotRealm {
    /** Starts programs inside the robot's realm as the brick's menu does. */
    private static final String LAUNCHER = "lejos.internal.ev3.EV3Wrapper";

    private final RobotContext robot;
    private final RobotClassLoader loader;
    private final Kernel kernel;

    RobotRealm(RobotContext robot, String mainClass, Kernel kernel, BrickHardware brick, Optional<ProgramBody> body) {
        this.robot = robot;
        this.kernel = kernel;
        loader = robot.loader();
        kernel.bind(robot.bind(kernel));
        kernel.beforeTurn(robot::enter);
        attach(brick);
        Thread main = robot.during(() -> body.isPresent() ? loader.programThread("main", () -> run(body.get()))
                : loader.mainThread(LAUNCHER, mainClass));
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
        robot.during(() -> {
            try {
                return loader.loadClass(BrickAccess.class.getName()).getMethod("attach", BrickHardware.class)
                        .invoke(null, brick);
            } catch (ReflectiveOperationException e) {
                throw new IllegalStateException("the robot's own BrickAccess must be there", e);
            }
        });
    }

    /** Ends the program from outside, e.g. within a physics step, on a thread of its own: shutdown hooks still run. */
    void end(int status) {
        kernel.start(robot.during(() -> loader.programThread("menu", () -> kernel.exit(status))));
    }

    /** Lets go of the program: disconnects kernel and brick. */
    void release() {
        attach(null);
        robot.bind(null);
    }
}
