package brickless.files;

import java.nio.file.FileStore;
import java.nio.file.attribute.BasicFileAttributeView;
import java.nio.file.attribute.FileAttributeView;
import java.nio.file.attribute.FileStoreAttributeView;

/** The memory card of a brick. */
final class BrickFileStore extends FileStore {
    private final BrickFiles files;

    BrickFileStore(BrickFiles files) {
        this.files = files;
    }

    @Override
    public String name() {
        return "card";
    }

    @Override
    public String type() {
        return "memory";
    }

    @Override
    public boolean isReadOnly() {
        return false;
    }

    @Override
    public long getTotalSpace() {
        return BrickFiles.CAPACITY_BYTES;
    }

    @Override
    public long getUsableSpace() {
        return files.freeBytes();
    }

    @Override
    public long getUnallocatedSpace() {
        return files.freeBytes();
    }

    @Override
    public boolean supportsFileAttributeView(Class<? extends FileAttributeView> type) {
        return type == BasicFileAttributeView.class;
    }

    @Override
    public boolean supportsFileAttributeView(String name) {
        return name.equals("basic");
    }

    @Override
    public <V extends FileStoreAttributeView> V getFileStoreAttributeView(Class<V> type) {
        return null;
    }

    /** @throws UnsupportedOperationException always */
    @Override
    public Object getAttribute(String attribute) {
        throw new UnsupportedOperationException("a simulated card has no attribute " + attribute);
    }
}
