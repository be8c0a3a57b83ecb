package brickless.kernel.hooks;

import java.io.File;
import java.io.FileDescriptor;
import java.io.FileNotFoundException;
import java.io.InputStreamReader;
import java.nio.charset.Charset;

/**
 * What {@code FileReader} is in a rewritten program: reads a file of the brick, UTF-8 unless told otherwise. Per
 * robot.
 */
public class ProgramFileReader extends InputStreamReader {
    /** Reads a file. */
    public ProgramFileReader(String name) throws FileNotFoundException {
        this(name, LocaleHooks.charset());
    }

    /** Reads a file. */
    public ProgramFileReader(File file) throws FileNotFoundException {
        this(file, LocaleHooks.charset());
    }

    /** Reads a file in that encoding. */
    public ProgramFileReader(String name, Charset charset) throws FileNotFoundException {
        super(new ProgramFileInputStream(name), charset);
    }

    /** Reads a file in that encoding. */
    public ProgramFileReader(File file, Charset charset) throws FileNotFoundException {
        super(new ProgramFileInputStream(file), charset);
    }

    /** @throws UnsupportedOperationException always */
    public ProgramFileReader(FileDescriptor descriptor) {
        super(new ProgramFileInputStream(descriptor));
    }
}
