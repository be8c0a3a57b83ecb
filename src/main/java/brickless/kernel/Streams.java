package brickless.kernel;

import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;

/** The program's {@code System.out}, {@code System.err} and {@code System.in}: silent and empty until set. */
final class Streams {
    private PrintStream out = new PrintStream(OutputStream.nullOutputStream());
    private PrintStream err = new PrintStream(OutputStream.nullOutputStream());
    private InputStream in = InputStream.nullInputStream();

    PrintStream out() {
        return out;
    }

    PrintStream err() {
        return err;
    }

    InputStream in() {
        return in;
    }

    /** Sets those that are not null. */
    void set(PrintStream newOut, PrintStream newErr, InputStream newIn) {
        out = newOut == null ? out : newOut;
        err = newErr == null ? err : newErr;
        in = newIn == null ? in : newIn;
    }
}
