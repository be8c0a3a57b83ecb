package brickless.simulation;

import brickless.hardware.ProgramLog;
import java.io.PrintStream;

/** What a live program tells: recorded like that of any program, and passed on to the JVM's own streams. */
final class LiveLog implements ProgramLog {
    private final ProgramConsole console;
    private final PrintStream out;
    private final PrintStream err;

    LiveLog(ProgramConsole console, PrintStream out, PrintStream err) {
        this.console = console;
        this.out = out;
        this.err = err;
    }

    @Override
    public void printed(byte[] bytes, int offset, int length, boolean error) {
        PrintStream stream = error ? err : out;
        stream.write(bytes, offset, length);
        stream.flush();
        console.printed(bytes, offset, length, error);
    }

    @Override
    public void uncaught(Thread thread, Throwable exception) {
        err.print("Exception in thread \"" + thread.getName() + "\" ");
        exception.printStackTrace(err);
        console.uncaught(thread, exception);
    }

    @Override
    public int arbitratorCreated(String[] behaviours) {
        return console.arbitratorCreated(behaviours);
    }

    @Override
    public void behaviourWanted(int arbitrator, int behaviour) {
        console.behaviourWanted(arbitrator, behaviour);
    }

    @Override
    public void behaviourActive(int arbitrator, int behaviour) {
        console.behaviourActive(arbitrator, behaviour);
    }

    @Override
    public void behaviourSuppressed(int arbitrator, int behaviour) {
        console.behaviourSuppressed(arbitrator, behaviour);
    }

    @Override
    public void endProgram(int status) {
        console.endProgram(status);
    }
}
