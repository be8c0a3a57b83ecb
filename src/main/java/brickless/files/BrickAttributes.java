package brickless.files;

import java.io.IOException;
import java.nio.file.attribute.BasicFileAttributeView;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.LinkedHashMap;
import java.util.Map;

/** What is known of a file: kind, length and the time of the last change, which also stands for the other times. */
record BrickAttributes(boolean isDirectory, long size, FileTime lastModifiedTime) implements BasicFileAttributes {
    static BrickAttributes of(BrickFiles files, String path) {
        return new BrickAttributes(files.isFolder(path), files.length(path),
                FileTime.fromMillis(files.modifiedMillis(path)));
    }

    @Override
    public FileTime lastAccessTime() {
        return lastModifiedTime;
    }

    @Override
    public FileTime creationTime() {
        return lastModifiedTime;
    }

    @Override
    public boolean isRegularFile() {
        return !isDirectory;
    }

    @Override
    public boolean isSymbolicLink() {
        return false;
    }

    @Override
    public boolean isOther() {
        return false;
    }

    @Override
    public Object fileKey() {
        return null;
    }

    /** By name, as {@code Files.readAttributes(path, "*")} has them. */
    Map<String, Object> byName() {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("size", size);
        all.put("lastModifiedTime", lastModifiedTime);
        all.put("lastAccessTime", lastModifiedTime);
        all.put("creationTime", lastModifiedTime);
        all.put("isDirectory", isDirectory);
        all.put("isRegularFile", !isDirectory);
        all.put("isSymbolicLink", false);
        all.put("isOther", false);
        all.put("fileKey", null);
        return all;
    }

    /** The view that sets the time. */
    record View(BrickFileSystemProvider provider, BrickPath path) implements BasicFileAttributeView {
        @Override
        public String name() {
            return "basic";
        }

        @Override
        public BasicFileAttributes readAttributes() throws IOException {
            return provider.attributes(path);
        }

        @Override
        public void setTimes(FileTime lastModified, FileTime lastAccess, FileTime created) throws IOException {
            if (lastModified != null) {
                path.getFileSystem().files().setModifiedMillis(path.toString(), lastModified.toMillis());
            }
        }
    }
}
