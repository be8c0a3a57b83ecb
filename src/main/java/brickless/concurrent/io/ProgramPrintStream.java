package brickless.concurrent.io;

import brickless.kernel.hooks.ProgramFileOutputStream;
import java.io.File;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.util.Formatter;
import java.util.Locale;

/**
 * A {@code java.io.PrintStream} that never holds a lock of the JDK while it calls the target stream; only its own
 * monitor.
 *
 * <p>Nothing of the host shows: the encoding is UTF-8 unless a constructor says otherwise, lines end in {@code \n},
 * numbers are formatted for {@code Locale.US}. A pair of surrogates has to be printed by one call.
 */
public class ProgramPrintStream extends PrintStream {
    private final boolean autoFlush;
    private final Charset charset;
    // Guarded by the stream:
    private boolean trouble;
    private boolean closed;

    /** Prints to {@code out} in UTF-8. */
    public ProgramPrintStream(OutputStream out) {
        this(out, false);
    }

    /** Prints to {@code out} in UTF-8; {@code autoFlush} flushes after each line and each array of bytes. */
    public ProgramPrintStream(OutputStream out, boolean autoFlush) {
        this(out, autoFlush, StandardCharsets.UTF_8);
    }

    /** Prints to {@code out} in that encoding. */
    public ProgramPrintStream(OutputStream out, boolean autoFlush, String encoding)
            throws UnsupportedEncodingException {
        this(out, autoFlush, charset(encoding));
    }

    /** Prints to {@code out} in that encoding. */
    public ProgramPrintStream(OutputStream out, boolean autoFlush, Charset charset) {
        super(OutputStream.nullOutputStream(), false, charset);
        if (out == null) {
            throw new NullPointerException("Null output stream");
        }
        this.out = out;
        this.autoFlush = autoFlush;
        this.charset = charset;
    }

    /** Prints to a new file in UTF-8. */
    public ProgramPrintStream(String fileName) throws FileNotFoundException {
        this(new ProgramFileOutputStream(fileName));
    }

    /** Prints to a new file in that encoding. */
    public ProgramPrintStream(String fileName, String csn) throws FileNotFoundException, UnsupportedEncodingException {
        this(new File(fileName), csn);
    }

    /** Prints to a new file in that encoding. */
    public ProgramPrintStream(String fileName, Charset charset) throws IOException {
        this(new File(fileName), charset);
    }

    /** Prints to a new file in UTF-8. */
    public ProgramPrintStream(File file) throws FileNotFoundException {
        this(new ProgramFileOutputStream(file));
    }

    /** Prints to a new file in that encoding. */
    public ProgramPrintStream(File file, String csn) throws FileNotFoundException, UnsupportedEncodingException {
        this(charset(csn), file);
    }

    /** Prints to a new file in that encoding. */
    public ProgramPrintStream(File file, Charset charset) throws IOException {
        this(charset, file);
    }

    /** The encoding comes first so that a bad one leaves no empty file behind. */
    private ProgramPrintStream(Charset charset, File file) throws FileNotFoundException {
        this(new ProgramFileOutputStream(file), false, charset);
    }

    private static Charset charset(String name) throws UnsupportedEncodingException {
        try {
            return Charset.forName(name);
        } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
            throw new UnsupportedEncodingException(name);
        }
    }

    /** Something to do with the target stream. */
    private interface Output {
        void run() throws IOException;
    }

    private synchronized void output(Output action) {
        try {
            if (closed) {
                throw new IOException("Stream closed");
            }
            action.run();
        } catch (InterruptedIOException e) {
            Thread.currentThread().interrupt();
        } catch (IOException e) {
            trouble = true;
        }
    }

    private void put(String text, boolean endOfLine) {
        output(() -> {
            out.write((endOfLine ? text + '\n' : text).getBytes(charset));
            if (autoFlush && (endOfLine || text.indexOf('\n') >= 0)) {
                out.flush();
            }
        });
    }

    @Override
    public void write(int b) {
        output(() -> {
            out.write(b);
            if (autoFlush && b == '\n') {
                out.flush();
            }
        });
    }

    @Override
    public void write(byte[] buf, int off, int len) {
        output(() -> {
            out.write(buf, off, len);
            if (autoFlush) {
                out.flush();
            }
        });
    }

    @Override
    public void write(byte[] buf) throws IOException {
        write(buf, 0, buf.length);
    }

    @Override
    public void writeBytes(byte[] buf) {
        write(buf, 0, buf.length);
    }

    @Override
    public void flush() {
        output(out::flush);
    }

    @Override
    public synchronized void close() {
        if (!closed) {
            output(out::close);
            closed = true;
        }
    }

    @Override
    public synchronized boolean checkError() {
        if (!closed) {
            flush();
        }
        return trouble || out instanceof PrintStream && ((PrintStream) out).checkError();
    }

    @Override
    protected synchronized void setError() {
        trouble = true;
    }

    @Override
    protected synchronized void clearError() {
        trouble = false;
    }

    @Override
    public void print(boolean b) {
        print(String.valueOf(b));
    }

    @Override
    public void print(char c) {
        print(String.valueOf(c));
    }

    @Override
    public void print(int i) {
        print(String.valueOf(i));
    }

    @Override
    public void print(long l) {
        print(String.valueOf(l));
    }

    @Override
    public void print(float f) {
        print(String.valueOf(f));
    }

    @Override
    public void print(double d) {
        print(String.valueOf(d));
    }

    @Override
    public void print(char[] s) {
        print(String.valueOf(s));
    }

    @Override
    public void print(String s) {
        put(String.valueOf(s), false);
    }

    @Override
    public void print(Object obj) {
        print(String.valueOf(obj));
    }

    @Override
    public void println() {
        put("", true);
    }

    @Override
    public void println(boolean x) {
        println(String.valueOf(x));
    }

    @Override
    public void println(char x) {
        println(String.valueOf(x));
    }

    @Override
    public void println(int x) {
        println(String.valueOf(x));
    }

    @Override
    public void println(long x) {
        println(String.valueOf(x));
    }

    @Override
    public void println(float x) {
        println(String.valueOf(x));
    }

    @Override
    public void println(double x) {
        println(String.valueOf(x));
    }

    @Override
    public void println(char[] x) {
        println(String.valueOf(x));
    }

    @Override
    public void println(String x) {
        put(String.valueOf(x), true);
    }

    @Override
    public void println(Object x) {
        println(String.valueOf(x));
    }

    @Override
    public PrintStream printf(String format, Object... args) {
        return format(format, args);
    }

    @Override
    public PrintStream printf(Locale l, String format, Object... args) {
        return format(l, format, args);
    }

    @Override
    public PrintStream format(String format, Object... args) {
        return format(Locale.US, format, args);
    }

    @Override
    public PrintStream format(Locale l, String format, Object... args) {
        print(new Formatter(new StringBuilder(), l).format(withFixedLineEnds(format), args).toString());
        return this;
    }

    /** {@code %n} would become the line separator of the host; {@code %%n} must stay. */
    private static String withFixedLineEnds(String format) {
        StringBuilder fixed = new StringBuilder();
        for (int i = 0; i < format.length(); i++) {
            char c = format.charAt(i);
            char next = c == '%' && i + 1 < format.length() ? format.charAt(i + 1) : 0;
            if (next == 'n') {
                fixed.append('\n');
                i++;
            } else if (next == '%') {
                fixed.append("%%");
                i++;
            } else {
                fixed.append(c);
            }
        }
        return fixed.toString();
    }

    @Override
    public PrintStream append(CharSequence csq) {
        print(String.valueOf(csq));
        return this;
    }

    @Override
    public PrintStream append(CharSequence csq, int start, int end) {
        return append(String.valueOf(csq).subSequence(start, end));
    }

    @Override
    public PrintStream append(char c) {
        print(c);
        return this;
    }
}
