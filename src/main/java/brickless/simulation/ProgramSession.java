package brickless.simulation;

import brickless.files.BrickFiles;
import brickless.kernel.Kernel;
import brickless.kernel.KernelSettings;
import brickless.loading.RobotContext;
import java.util.Optional;

/** One program of a run in virtual time: its kernel, its classes, and the robot it drives. */
final class ProgramSession implements RobotSession.ProgramExit {
    private static final long NANOS_PER_MILLI = 1_000_000;

    private final Kernel kernel;
    private final RobotSession robot;
    private final RobotRealm realm;

    ProgramSession(SimulationSettings settings, Crew.Member member, Stage stage, RobotContext context,
            Optional<ProgramBody> body) {
        kernel = new Kernel(kernelSettings(settings, member.name(), stage.stepNanos()));
        robot = stage.enter(member, kernel, member.fitted() || body.isPresent(), this);
        long epochMillis = kernel.settings().epochMillis();
        BrickFiles files = new BrickFiles(epochMillis, () -> epochMillis + kernel.nowNanos() / NANOS_PER_MILLI);
        new Upload(files, settings).put(member.folder());
        kernel.files(files);
        robot.carry(files);
        realm = new RobotRealm(context, member.program().mainClass(), kernel, robot.brick(robot.console()), body);
    }

    private static KernelSettings kernelSettings(SimulationSettings settings, String name, long stepNanos) {
        KernelSettings kernelSettings = KernelSettings.defaults().withName(name).withSeed(settings.seed())
                .withStepNanos(stepNanos)
                .withLimitNanos(settings.limit().toNanos()).withBackend(settings.backend());
        return settings.scheduleSeed().isPresent() ? kernelSettings.withScheduleSeed(settings.scheduleSeed()
                .getAsLong()) : kernelSettings;
    }

    Kernel kernel() {
        return kernel;
    }

    RobotSession robot() {
        return robot;
    }

    @Override
    public void exit(int status) {
        kernel.exit(status);
    }

    @Override
    public void endByKeys() {
        realm.end(1);
    }

    @Override
    public boolean over() {
        return kernel.end() != null;
    }

    /** Lets go of the program's classes. */
    void release() {
        realm.release();
    }
}
