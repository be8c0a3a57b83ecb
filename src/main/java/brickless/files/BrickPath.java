package brickless.files;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.ProviderMismatchException;
import java.nio.file.WatchEvent;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.ArrayList;
import java.util.List;

/** A path of a brick's file system. Immutable. */
final class BrickPath implements Path {
    private final BrickFileSystem fileSystem;
    private final boolean absolute;
    /** The empty path has one empty name. */
    private final List<String> names;

    private BrickPath(BrickFileSystem fileSystem, boolean absolute, List<String> names) {
        this.fileSystem = fileSystem;
        this.absolute = absolute;
        this.names = !absolute && names.isEmpty() ? List.of("") : List.copyOf(names);
    }

    static BrickPath of(BrickFileSystem fileSystem, String text) {
        return new BrickPath(fileSystem, text.startsWith("/"), Names.split(text));
    }

    /** The path as one of this package. */
    static BrickPath of(Path path) {
        if (path == null) {
            throw new NullPointerException("path");
        }
        if (!(path instanceof BrickPath)) {
            throw new ProviderMismatchException();
        }
        return (BrickPath) path;
    }

    private BrickPath with(boolean nowAbsolute, List<String> newNames) {
        return new BrickPath(fileSystem, nowAbsolute, newNames);
    }

    private boolean isEmpty() {
        return !absolute && names.get(0).isEmpty();
    }

    @Override
    public BrickFileSystem getFileSystem() {
        return fileSystem;
    }

    @Override
    public boolean isAbsolute() {
        return absolute;
    }

    @Override
    public Path getRoot() {
        return absolute ? with(true, List.of()) : null;
    }

    @Override
    public Path getFileName() {
        return names.isEmpty() ? null : getName(names.size() - 1);
    }

    @Override
    public Path getParent() {
        if (names.size() > 1) {
            return with(absolute, names.subList(0, names.size() - 1));
        }
        return names.isEmpty() ? null : getRoot();
    }

    @Override
    public int getNameCount() {
        return names.size();
    }

    @Override
    public Path getName(int index) {
        return subpath(index, index + 1);
    }

    @Override
    public Path subpath(int beginIndex, int endIndex) {
        if (beginIndex < 0 || endIndex > names.size() || beginIndex >= endIndex) {
            throw new IllegalArgumentException("names " + beginIndex + " to " + endIndex + " of " + names.size());
        }
        return with(false, names.subList(beginIndex, endIndex));
    }

    @Override
    public boolean startsWith(Path other) {
        if (!(other instanceof BrickPath) || absolute != other.isAbsolute()) {
            return false;
        }
        List<String> start = ((BrickPath) other).names;
        return start.size() <= names.size() && names.subList(0, start.size()).equals(start);
    }

    @Override
    public boolean endsWith(Path other) {
        if (!(other instanceof BrickPath)) {
            return false;
        }
        List<String> end = ((BrickPath) other).names;
        if (other.isAbsolute()) {
            return absolute && names.equals(end);
        }
        return end.size() <= names.size() && names.subList(names.size() - end.size(), names.size()).equals(end);
    }

    @Override
    public Path normalize() {
        List<String> kept = new ArrayList<>();
        for (String name : names) {
            boolean canGoUp = !kept.isEmpty() && !kept.get(kept.size() - 1).equals("..");
            if (name.equals("..") && canGoUp) {
                kept.remove(kept.size() - 1);
            } else if (!name.equals(".") && !(name.equals("..") && absolute)) {
                kept.add(name);
            }
        }
        return with(absolute, kept);
    }

    @Override
    public Path resolve(Path other) {
        BrickPath added = of(other);
        if (added.absolute || isEmpty()) {
            return added;
        }
        if (added.isEmpty()) {
            return this;
        }
        List<String> joined = new ArrayList<>(names);
        joined.addAll(added.names);
        return with(absolute, joined);
    }

    @Override
    public Path relativize(Path other) {
        BrickPath target = of(other);
        if (absolute != target.absolute) {
            throw new IllegalArgumentException("'other' is different type of Path");
        }
        if (isEmpty()) {
            return target;
        }
        int common = 0;
        while (common < names.size() && common < target.names.size()
                && names.get(common).equals(target.names.get(common))) {
            common++;
        }
        List<String> way = new ArrayList<>();
        names.subList(common, names.size()).forEach(up -> way.add(".."));
        if (!target.isEmpty()) {
            way.addAll(target.names.subList(common, target.names.size()));
        }
        return with(false, way);
    }

    @Override
    public URI toUri() {
        try {
            return new URI("file", null, toAbsolutePath().toString(), null);
        } catch (URISyntaxException e) {
            throw new IllegalStateException("an absolute path has a URI", e);
        }
    }

    @Override
    public Path toAbsolutePath() {
        return absolute ? this : of(fileSystem, Names.absolute(toString()));
    }

    @Override
    public Path toRealPath(LinkOption... options) throws IOException {
        if (!fileSystem.files().exists(toString())) {
            throw new NoSuchFileException(toString());
        }
        return of(fileSystem, Names.canonical(toString()));
    }

    /** @throws UnsupportedOperationException always */
    @Override
    public WatchKey register(WatchService watcher, WatchEvent.Kind<?>[] events, WatchEvent.Modifier... modifiers) {
        throw new UnsupportedOperationException("folders of a simulated brick cannot be watched");
    }

    @Override
    public int compareTo(Path other) {
        return toString().compareTo(of(other).toString());
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof BrickPath && ((BrickPath) other).fileSystem == fileSystem
                && ((BrickPath) other).toString().equals(toString());
    }

    @Override
    public int hashCode() {
        return toString().hashCode();
    }

    @Override
    public String toString() {
        return (absolute ? "/" : "") + String.join("/", names);
    }
}
