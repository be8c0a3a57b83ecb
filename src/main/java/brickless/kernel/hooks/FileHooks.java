package brickless.kernel.hooks;

import brickless.files.BrickFiles;
import java.io.BufferedInputStream;
import java.io.BufferedWriter;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Reader;
import java.io.SyncFailedException;
import java.io.UnsupportedEncodingException;
import java.io.Writer;
import java.net.URI;
import java.nio.channels.FileChannel;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.UnsupportedCharsetException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.util.Locale;
import java.util.Set;

/** Files of rewritten code: those of the robot's brick; without a kernel the host's. Per robot. */
public final class FileHooks {
    private FileHooks() {}

    /** The brick's files; null for the host's. */
    static BrickFiles files() {
        return Hooks.machine().files();
    }

    /** Opens a file for {@code java.io}. */
    static FileChannel open(String path, OpenOption... options) throws FileNotFoundException {
        BrickFiles files = files();
        try {
            return files == null ? FileChannel.open(Path.of(path), options) : files.open(path, Set.of(options));
        } catch (IOException | InvalidPathException e) {
            throw new FileNotFoundException(path + " (" + reason(e) + ")");
        }
    }

    private static String reason(Exception e) {
        if (e instanceof NoSuchFileException) {
            return "No such file or directory";
        }
        String reason = e instanceof FileSystemException ? ((FileSystemException) e).getReason() : e.getMessage();
        return reason == null ? "Permission denied" : reason;
    }

    /** {@code Paths.get} and {@code Path.of}. */
    public static Path path(String first, String... more) {
        return fileSystem().getPath(first, more);
    }

    /** {@code Paths.get} and {@code Path.of}. */
    public static Path path(URI uri) {
        return files() != null && "file".equalsIgnoreCase(uri.getScheme()) ? fileSystem().provider().getPath(uri)
                : Path.of(uri);
    }

    /** {@code FileSystems.getDefault}. */
    public static FileSystem fileSystem() {
        BrickFiles files = files();
        return files == null ? FileSystems.getDefault() : files.fileSystem();
    }

    /** {@code path.toFile()}. */
    public static File toFile(Path path) {
        if (path.getFileSystem() != fileSystem()) {
            return path.toFile();
        }
        return new ProgramFile(path.toString());
    }

    /** {@code descriptor.sync()}: a brick's files are safe at once. */
    public static void sync(FileDescriptor descriptor) throws SyncFailedException {
        if (files() == null) {
            descriptor.sync();
        }
    }

    /** {@code Files.createTempFile(prefix, suffix)}. */
    public static Path createTempFile(String prefix, String suffix, FileAttribute<?>... attributes)
            throws IOException {
        return files() == null ? Files.createTempFile(prefix, suffix, attributes)
                : createTempFile(path(PropertyHooks.getProperty("java.io.tmpdir")), prefix, suffix, attributes);
    }

    /** {@code Files.createTempFile(folder, prefix, suffix)}. */
    public static Path createTempFile(Path folder, String prefix, String suffix, FileAttribute<?>... attributes)
            throws IOException {
        return files() == null ? Files.createTempFile(folder, prefix, suffix, attributes)
                : Files.createFile(folder.resolve(temporaryName(prefix, suffix == null ? ".tmp" : suffix)));
    }

    /** {@code Files.createTempDirectory(prefix)}. */
    public static Path createTempDirectory(String prefix, FileAttribute<?>... attributes) throws IOException {
        return files() == null ? Files.createTempDirectory(prefix, attributes)
                : createTempDirectory(path(PropertyHooks.getProperty("java.io.tmpdir")), prefix, attributes);
    }

    /** {@code Files.createTempDirectory(folder, prefix)}. */
    public static Path createTempDirectory(Path folder, String prefix, FileAttribute<?>... attributes)
            throws IOException {
        return files() == null ? Files.createTempDirectory(folder, prefix, attributes)
                : Files.createDirectory(folder.resolve(temporaryName(prefix, "")));
    }

    /** Counted, so that it is the same in every run. */
    static String temporaryName(String prefix, String suffix) {
        return (prefix == null ? "" : prefix) + files().nextTemporaryNumber() + suffix;
    }

    /** What {@code new PrintWriter(name)} writes to. */
    public static Writer writer(String name) throws FileNotFoundException {
        return writer(name, LocaleHooks.charset());
    }

    /** What {@code new PrintWriter(name, encoding)} writes to. */
    public static Writer writer(String name, String encoding) throws FileNotFoundException,
            UnsupportedEncodingException {
        return writer(name, charset(encoding));
    }

    /** What {@code new PrintWriter(name, encoding)} writes to. */
    public static Writer writer(String name, Charset charset) throws FileNotFoundException {
        return new BufferedWriter(new OutputStreamWriter(new ProgramFileOutputStream(name), charset));
    }

    /** What {@code new PrintWriter(file)} writes to. */
    public static Writer writer(File file) throws FileNotFoundException {
        return writer(file.getPath());
    }

    /** What {@code new PrintWriter(file, encoding)} writes to. */
    public static Writer writer(File file, String encoding) throws FileNotFoundException,
            UnsupportedEncodingException {
        return writer(file.getPath(), encoding);
    }

    /** What {@code new PrintWriter(file, encoding)} writes to. */
    public static Writer writer(File file, Charset charset) throws FileNotFoundException {
        return writer(file.getPath(), charset);
    }

    /** What {@code new Formatter(name)} writes to. */
    public static Appendable appendable(String name) throws FileNotFoundException {
        return writer(name);
    }

    /** What {@code new Formatter(name, encoding)} writes to. */
    public static Appendable appendable(String name, String encoding) throws FileNotFoundException,
            UnsupportedEncodingException {
        return writer(name, encoding);
    }

    /** What {@code new Formatter(file, encoding)} writes to. */
    public static Appendable appendable(File file, String encoding) throws FileNotFoundException,
            UnsupportedEncodingException {
        return writer(file, encoding);
    }

    /** What {@code new Formatter(file)} writes to. */
    public static Appendable appendable(File file) throws FileNotFoundException {
        return writer(file);
    }

    /** What {@code new Scanner(file)} reads from. */
    public static Readable readable(File file) throws FileNotFoundException {
        return reader(file, LocaleHooks.charset());
    }

    /** What {@code new Scanner(file, encoding)} reads from. */
    public static Readable readable(File file, String encoding) throws FileNotFoundException {
        return reader(file, Charset.forName(encoding));
    }

    private static Reader reader(File file, Charset charset) throws FileNotFoundException {
        return new InputStreamReader(new ProgramFileInputStream(file), charset);
    }

    /** Encodings of {@code java.io} have exceptions of their own. */
    static Charset charset(String name) throws UnsupportedEncodingException {
        try {
            return Charset.forName(name);
        } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
            throw new UnsupportedEncodingException(name);
        }
    }

    /** What {@code ImageIO.read(file)} and its like read from. */
    public static InputStream input(File file) throws FileNotFoundException {
        return new BufferedInputStream(new ProgramFileInputStream(file));
    }

    /** What {@code ImageIO.write(image, format, file)} writes to. */
    public static OutputStream output(File file) throws FileNotFoundException {
        return new ProgramFileOutputStream(file);
    }

    /**
     * An argument of a class of the JDK that opens files by itself, which it can on the host only.
     *
     * @throws UnsupportedOperationException on a simulated brick
     */
    public static String hostOnly(String argument) {
        refuseOnABrick();
        return argument;
    }

    /** See {@link #hostOnly(String)}. */
    public static File hostOnly(File argument) {
        refuseOnABrick();
        return argument;
    }

    /** See {@link #hostOnly(String)}. */
    public static Charset hostOnly(Charset argument) {
        refuseOnABrick();
        return argument;
    }

    /** See {@link #hostOnly(String)}. */
    public static Locale hostOnly(Locale argument) {
        refuseOnABrick();
        return argument;
    }

    /** See {@link #hostOnly(String)}. */
    public static boolean hostOnly(boolean argument) {
        refuseOnABrick();
        return argument;
    }

    /** See {@link #hostOnly(String)}. */
    public static int hostOnly(int argument) {
        refuseOnABrick();
        return argument;
    }

    /** Where {@code new FileHandler()} logs; see {@link #hostOnly(String)}. */
    public static String hostLog() {
        return hostOnly("%h/java%u.log");
    }

    private static void refuseOnABrick() {
        if (files() != null) {
            throw new UnsupportedOperationException("this class of the JDK opens files by itself, which it cannot on a "
                    + "simulated brick; give it a stream, or use another class");
        }
    }
}
