package brickless.loading;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.util.Collections;
import java.util.List;

/** Class files that another loader, usually the application's, can read. */
final class LoaderClassSource implements ClassSource {
    private final ClassLoader loader;

    LoaderClassSource(ClassLoader loader) {
        this.loader = loader;
    }

    @Override
    public ClassFile find(String internalName) {
        URL url = loader.getResource(internalName + ".class");
        if (url == null) {
            return null;
        }
        try (InputStream in = url.openStream()) {
            return new ClassFile(in.readAllBytes(), url.toString());
        } catch (IOException unreadable) {
            throw new UncheckedIOException("cannot read " + url, unreadable);
        }
    }

    @Override
    public List<URL> resources(String path) throws IOException {
        return Collections.list(loader.getResources(path));
    }

    @Override
    public void close() {
        // the loader belongs to somebody else
    }
}
