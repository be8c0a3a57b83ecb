package brickless.kernel.hooks;

import java.io.File;
import java.io.FileDescriptor;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.nio.charset.Charset;

/**
 * What {@code FileWriter} is in a rewritten program: writes a file of the brick, UTF-8 unless told otherwise. Per
 * robot.
 */
public class ProgramFileWriter extends OutputStreamWriter {
    /** Writes a new file. */
    public ProgramFileWriter(String file) throws IOException {
        this(file, false);
    }

    /** Writes or extends a file. */
    public ProgramFileWriter(String file, boolean append) throws IOException {
        this(file, LocaleHooks.charset(), append);
    }

    /** Writes a new file. */
    public ProgramFileWriter(File file) throws IOException {
        this(file, false);
    }

    /** Writes or extends a file. */
    public ProgramFileWriter(File file, boolean append) throws IOException {
        this(file, LocaleHooks.charset(), append);
    }

    /** Writes a new file in that encoding. */
    public ProgramFileWriter(String file, Charset charset) throws IOException {
        this(file, charset, false);
    }

    /** Writes or extends a file in that encoding. */
    public ProgramFileWriter(String file, Charset charset, boolean append) throws IOException {
        super(new ProgramFileOutputStream(file, append), charset);
    }

    /** Writes a new file in that encoding. */
    public ProgramFileWriter(File file, Charset charset) throws IOException {
        this(file, charset, false);
    }

    /** Writes or extends a file in that encoding. */
    public ProgramFileWriter(File file, Charset charset, boolean append) throws IOException {
        super(new ProgramFileOutputStream(file, append), charset);
    }

    /** Writes to the console; see {@link ProgramFileOutputStream#ProgramFileOutputStream(FileDescriptor)}. */
    public ProgramFileWriter(FileDescriptor descriptor) {
        super(new ProgramFileOutputStream(descriptor), LocaleHooks.charset());
    }
}
