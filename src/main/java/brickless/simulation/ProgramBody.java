package brickless.simulation;

/** What a program does when it is not the main method of a class: the body of a test, for example. */
@FunctionalInterface
public interface ProgramBody {
    /**
     * Runs as the program's main thread, in virtual time, with screen and console made ready. What it throws ends that
     * thread as an uncaught exception does.
     *
     * @param robot loader of the robot's own classes: only classes loaded by it see the robot and the virtual time
     */
    void run(ClassLoader robot) throws Throwable;
}
