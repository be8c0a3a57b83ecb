package brickless.kernel.hooks;

import java.io.File;
import java.io.FileDescriptor;
import java.io.FileWriter;
import java.io.IOException;
import java.nio.charset.Charset;

/** What {@code new FileWriter} becomes in a rewritten program: UTF-8 unless the program says otherwise. Per robot. */
public class ProgramFileWriter extends FileWriter {
    /** Writes a new file. */
    public ProgramFileWriter(String file) throws IOException {
        super(file, LocaleHooks.charset());
    }

    /** Writes or extends a file. */
    public ProgramFileWriter(String file, boolean append) throws IOException {
        super(file, LocaleHooks.charset(), append);
    }

    /** Writes a new file. */
    public ProgramFileWriter(File file) throws IOException {
        super(file, LocaleHooks.charset());
    }

    /** Writes or extends a file. */
    public ProgramFileWriter(File file, boolean append) throws IOException {
        super(file, LocaleHooks.charset(), append);
    }

    /** Writes a new file in that encoding. */
    public ProgramFileWriter(String file, Charset charset) throws IOException {
        super(file, charset);
    }

    /** Writes or extends a file in that encoding. */
    public ProgramFileWriter(String file, Charset charset, boolean append) throws IOException {
        super(file, charset, append);
    }

    /** Writes a new file in that encoding. */
    public ProgramFileWriter(File file, Charset charset) throws IOException {
        super(file, charset);
    }

    /** Writes or extends a file in that encoding. */
    public ProgramFileWriter(File file, Charset charset, boolean append) throws IOException {
        super(file, charset, append);
    }

    /** Writes to an open file; in the host's encoding, which no constructor can change. */
    public ProgramFileWriter(FileDescriptor descriptor) {
        super(descriptor);
    }
}
