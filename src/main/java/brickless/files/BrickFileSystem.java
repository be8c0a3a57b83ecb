package brickless.files;

import java.nio.file.FileStore;
import java.nio.file.FileSystem;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.nio.file.WatchService;
import java.nio.file.attribute.UserPrincipalLookupService;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;

/** {@link BrickFiles} for {@code java.nio.file}. */
final class BrickFileSystem extends FileSystem {
    private final BrickFiles files;
    private final BrickFileSystemProvider provider = new BrickFileSystemProvider(this);

    BrickFileSystem(BrickFiles files) {
        this.files = files;
    }

    BrickFiles files() {
        return files;
    }

    @Override
    public BrickFileSystemProvider provider() {
        return provider;
    }

    /** @throws UnsupportedOperationException always, like that of the default file system */
    @Override
    public void close() {
        throw new UnsupportedOperationException("the brick's file system cannot be closed");
    }

    @Override
    public boolean isOpen() {
        return true;
    }

    @Override
    public boolean isReadOnly() {
        return false;
    }

    @Override
    public String getSeparator() {
        return "/";
    }

    @Override
    public Iterable<Path> getRootDirectories() {
        return List.of(getPath("/"));
    }

    @Override
    public Iterable<FileStore> getFileStores() {
        return List.of(new BrickFileStore(files));
    }

    @Override
    public Set<String> supportedFileAttributeViews() {
        return Set.of("basic");
    }

    @Override
    public Path getPath(String first, String... more) {
        StringBuilder text = new StringBuilder(first);
        for (String name : more) {
            text.append(text.length() == 0 || name.isEmpty() ? "" : "/").append(name);
        }
        return BrickPath.of(this, text.toString());
    }

    @Override
    public PathMatcher getPathMatcher(String syntaxAndPattern) {
        int colon = syntaxAndPattern.indexOf(':');
        if (colon <= 0) {
            throw new IllegalArgumentException(syntaxAndPattern + ": allowed are glob:PATTERN and regex:PATTERN");
        }
        String pattern = syntaxAndPattern.substring(colon + 1);
        Pattern compiled;
        switch (syntaxAndPattern.substring(0, colon)) {
            case "glob":
                compiled = Pattern.compile(Glob.regularExpression(pattern));
                break;
            case "regex":
                compiled = Pattern.compile(pattern);
                break;
            default:
                throw new UnsupportedOperationException(syntaxAndPattern + ": allowed are glob:PATTERN and "
                        + "regex:PATTERN");
        }
        return path -> compiled.matcher(path.toString()).matches();
    }

    /** @throws UnsupportedOperationException always */
    @Override
    public UserPrincipalLookupService getUserPrincipalLookupService() {
        throw new UnsupportedOperationException("files of a simulated brick have no owners");
    }

    /** @throws UnsupportedOperationException always */
    @Override
    public WatchService newWatchService() {
        throw new UnsupportedOperationException("folders of a simulated brick cannot be watched");
    }
}
