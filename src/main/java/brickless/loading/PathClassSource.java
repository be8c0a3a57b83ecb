package brickless.loading;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarFile;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/**
 * A class path of directories and jars, first come first served. Of multi-release jars only the base version counts, on
 * every JDK.
 */
final class PathClassSource implements ClassSource {
    private final List<Entry> entries = new ArrayList<>();

    /**
     * Opens the jars.
     *
     * @throws IOException if an entry does not exist or is no readable jar; the message names it
     */
    PathClassSource(List<Path> classPath) throws IOException {
        try {
            for (Path path : classPath) {
                entries.add(open(path.toAbsolutePath()));
            }
        } catch (IOException unreadable) {
            close();
            throw unreadable;
        }
    }

    private static Entry open(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            return new Directory(path);
        }
        if (!Files.exists(path)) {
            throw new NoSuchFileException(path.toString(), null, "class path entry does not exist");
        }
        try {
            return new Jar(path);
        } catch (IOException unreadable) {
            throw new IOException(path + " is no directory and no readable jar", unreadable);
        }
    }

    @Override
    public ClassFile find(String internalName) {
        String path = internalName + ".class";
        for (Entry entry : entries) {
            try {
                byte[] bytes = entry.read(path);
                if (bytes != null) {
                    return new ClassFile(bytes, entry.toString());
                }
            } catch (IOException unreadable) {
                throw new UncheckedIOException("cannot read " + path + " from " + entry, unreadable);
            }
        }
        return null;
    }

    @Override
    public List<URL> resources(String path) throws IOException {
        List<URL> found = new ArrayList<>();
        for (Entry entry : entries) {
            URL url = entry.url(path);
            if (url != null) {
                found.add(url);
            }
        }
        return found;
    }

    @Override
    public void close() throws IOException {
        for (Entry entry : entries) {
            entry.close();
        }
    }

    /** One directory or jar. */
    private interface Entry {
        byte[] read(String path) throws IOException;

        URL url(String path) throws IOException;

        void close() throws IOException;
    }

    private static final class Directory implements Entry {
        private final Path root;

        Directory(Path root) {
            this.root = root;
        }

        @Override
        public byte[] read(String path) throws IOException {
            Path file = root.resolve(path);
            return Files.isRegularFile(file) ? Files.readAllBytes(file) : null;
        }

        @Override
        public URL url(String path) throws IOException {
            Path file = root.resolve(path).normalize();
            return file.startsWith(root.normalize()) && Files.exists(file) ? file.toUri().toURL() : null;
        }

        @Override
        public void close() {
            // nothing is open
        }

        @Override
        public String toString() {
            return root.toString();
        }
    }

    private static final class Jar implements Entry {
        private final JarFile jar;

        Jar(Path path) throws IOException {
            jar = new JarFile(path.toFile(), false, ZipFile.OPEN_READ, JarFile.baseVersion());
        }

        @Override
        public byte[] read(String path) throws IOException {
            ZipEntry entry = jar.getEntry(path);
            if (entry == null || entry.isDirectory()) {
                return null;
            }
            try (InputStream in = jar.getInputStream(entry)) {
                return in.readAllBytes();
            }
        }

        @Override
        public URL url(String path) throws IOException {
            if (jar.getEntry(path) == null) {
                return null;
            }
            try {
                String encoded = new URI(null, null, "/" + path, null).getRawPath();
                return new URL("jar:" + new File(jar.getName()).toURI() + "!" + encoded);
            } catch (URISyntaxException malformed) {
                throw new IOException("resource " + path + " of " + jar.getName(), malformed);
            }
        }

        @Override
        public void close() throws IOException {
            jar.close();
        }

        @Override
        public String toString() {
            return jar.getName();
        }
    }
}
