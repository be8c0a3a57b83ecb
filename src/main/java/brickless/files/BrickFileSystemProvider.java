package brickless.files;

import java.io.IOException;
import java.net.URI;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.AccessMode;
import java.nio.file.CopyOption;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileStore;
import java.nio.file.FileSystem;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributeView;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.FileAttributeView;
import java.nio.file.attribute.FileTime;
import java.nio.file.spi.FileSystemProvider;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Leads {@code java.nio.file.Files} to {@link BrickFiles}. Attributes asked for when a file is made are ignored: root
 * may all.
 */
final class BrickFileSystemProvider extends FileSystemProvider {
    private final BrickFileSystem fileSystem;

    BrickFileSystemProvider(BrickFileSystem fileSystem) {
        this.fileSystem = fileSystem;
    }

    private BrickFiles files() {
        return fileSystem.files();
    }

    private static String text(Path path) {
        return BrickPath.of(path).toString();
    }

    @Override
    public String getScheme() {
        return "file";
    }

    /** @throws UnsupportedOperationException always */
    @Override
    public FileSystem newFileSystem(URI uri, Map<String, ?> settings) {
        throw new UnsupportedOperationException("a simulated brick has one file system");
    }

    @Override
    public FileSystem getFileSystem(URI uri) {
        return fileSystem;
    }

    @Override
    public Path getPath(URI uri) {
        if (!"file".equalsIgnoreCase(uri.getScheme()) || uri.getPath() == null) {
            throw new IllegalArgumentException(uri + ": is not the URI of a file");
        }
        return BrickPath.of(fileSystem, uri.getPath());
    }

    @Override
    public FileChannel newFileChannel(Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
            throws IOException {
        return files().open(text(path), options);
    }

    @Override
    public SeekableByteChannel newByteChannel(Path path, Set<? extends OpenOption> options,
            FileAttribute<?>... attributes) throws IOException {
        return newFileChannel(path, options, attributes);
    }

    @Override
    public DirectoryStream<Path> newDirectoryStream(Path folder, DirectoryStream.Filter<? super Path> filter)
            throws IOException {
        List<Path> found = new ArrayList<>();
        for (String name : files().list(text(folder))) {
            found.add(folder.resolve(name));
        }
        return new Listing(found, filter);
    }

    @Override
    public void createDirectory(Path folder, FileAttribute<?>... attributes) throws IOException {
        files().createFolder(text(folder));
    }

    @Override
    public void delete(Path path) throws IOException {
        files().delete(text(path));
    }

    @Override
    public void copy(Path source, Path target, CopyOption... options) throws IOException {
        files().copy(text(source), text(target), replaces(options));
        if (Arrays.asList(options).contains(StandardCopyOption.COPY_ATTRIBUTES)) {
            files().setModifiedMillis(text(target), files().modifiedMillis(text(source)));
        }
    }

    @Override
    public void move(Path source, Path target, CopyOption... options) throws IOException {
        boolean atomic = Arrays.asList(options).contains(StandardCopyOption.ATOMIC_MOVE);
        files().move(text(source), text(target), atomic || replaces(options));
    }

    private static boolean replaces(CopyOption[] options) {
        return Arrays.asList(options).contains(StandardCopyOption.REPLACE_EXISTING);
    }

    @Override
    public boolean isSameFile(Path path, Path other) {
        return Names.canonical(text(path)).equals(Names.canonical(other.toString()));
    }

    @Override
    public boolean isHidden(Path path) {
        return path.getFileName() != null && path.getFileName().toString().startsWith(".");
    }

    @Override
    public FileStore getFileStore(Path path) {
        return new BrickFileStore(files());
    }

    @Override
    public void checkAccess(Path path, AccessMode... modes) throws IOException {
        attributes(path);
    }

    BrickAttributes attributes(Path path) throws IOException {
        if (!files().exists(text(path))) {
            throw new NoSuchFileException(text(path));
        }
        return BrickAttributes.of(files(), text(path));
    }

    @Override
    public <V extends FileAttributeView> V getFileAttributeView(Path path, Class<V> type, LinkOption... options) {
        return type == BasicFileAttributeView.class ? type.cast(new BrickAttributes.View(this, BrickPath.of(path)))
                : null;
    }

    @Override
    public <A extends BasicFileAttributes> A readAttributes(Path path, Class<A> type, LinkOption... options)
            throws IOException {
        if (type != BasicFileAttributes.class) {
            throw new UnsupportedOperationException("files of a simulated brick have basic attributes only");
        }
        return type.cast(attributes(path));
    }

    @Override
    public Map<String, Object> readAttributes(Path path, String names, LinkOption... options) throws IOException {
        Map<String, Object> all = attributes(path).byName();
        List<String> wanted = Arrays.asList(basic(names).split(","));
        if (!wanted.contains("*")) {
            all.keySet().retainAll(wanted);
        }
        return all;
    }

    @Override
    public void setAttribute(Path path, String name, Object value, LinkOption... options) throws IOException {
        if (!basic(name).equals("lastModifiedTime")) {
            throw new UnsupportedOperationException("attribute " + name
                    + " of a simulated brick's files cannot be set");
        }
        files().setModifiedMillis(text(path), ((FileTime) value).toMillis());
    }

    private static String basic(String names) {
        String plain = names.startsWith("basic:") ? names.substring("basic:".length()) : names;
        if (plain.contains(":")) {
            throw new UnsupportedOperationException("files of a simulated brick have basic attributes only");
        }
        return plain;
    }

    /** What a folder held when it was asked. */
    private record Listing(List<Path> found, DirectoryStream.Filter<? super Path> filter)
            implements DirectoryStream<Path> {
        @Override
        public Iterator<Path> iterator() {
            try {
                List<Path> accepted = new ArrayList<>();
                for (Path path : found) {
                    if (filter == null || filter.accept(path)) {
                        accepted.add(path);
                    }
                }
                return accepted.iterator();
            } catch (IOException e) {
                throw new DirectoryIteratorException(e);
            }
        }

        @Override
        public void close() {}
    }
}
