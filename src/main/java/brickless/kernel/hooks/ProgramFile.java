package brickless.kernel.hooks;

import brickless.files.BrickFiles;
import java.io.File;
import java.io.FileFilter;
import java.io.FilenameFilter;
import java.io.IOException;
import java.net.URI;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * What {@code new File} makes in a rewritten program: a name for a file of the robot's brick; without a kernel for one
 * of the host. Per robot.
 */
public class ProgramFile extends File {
    private static final long serialVersionUID = 1L;

    /** A name. */
    public ProgramFile(String path) {
        super(path);
    }

    /** A name in a folder. */
    public ProgramFile(String parent, String child) {
        super(parent, child);
    }

    /** A name in a folder. */
    public ProgramFile(File parent, String child) {
        super(parent, child);
    }

    /** A name from a {@code file:} URI. */
    public ProgramFile(URI uri) {
        super(uri);
    }

    private static BrickFiles brick() {
        return FileHooks.files();
    }

    /** The empty name stands for no file. */
    private boolean named() {
        return !getPath().isEmpty();
    }

    private static File of(File file) {
        return file == null ? null : new ProgramFile(file.getPath());
    }

    /** Something to do with a file that may not be possible. */
    private interface Change {
        void run() throws IOException;
    }

    private static boolean succeeds(Change change) {
        try {
            change.run();
            return true;
        } catch (IOException impossible) {
            return false;
        }
    }

    @Override
    public File getParentFile() {
        return of(super.getParentFile());
    }

    @Override
    public String getAbsolutePath() {
        return brick() == null ? super.getAbsolutePath() : BrickFiles.absolute(getPath());
    }

    @Override
    public File getAbsoluteFile() {
        return new ProgramFile(getAbsolutePath());
    }

    @Override
    public String getCanonicalPath() throws IOException {
        return brick() == null ? super.getCanonicalPath() : BrickFiles.canonical(getPath());
    }

    @Override
    public File getCanonicalFile() throws IOException {
        return new ProgramFile(getCanonicalPath());
    }

    @Override
    public URI toURI() {
        return brick() == null ? super.toURI()
                : URI.create(new File(getAbsolutePath()).toURI().toString().replaceFirst("/$", "")
                + (isDirectory() ? "/" : ""));
    }

    @Override
    public Path toPath() {
        return brick() == null ? super.toPath() : brick().path(getPath());
    }

    @Override
    public boolean exists() {
        return brick() == null ? super.exists() : named() && brick().exists(getPath());
    }

    @Override
    public boolean isDirectory() {
        return brick() == null ? super.isDirectory() : named() && brick().isFolder(getPath());
    }

    @Override
    public boolean isFile() {
        return brick() == null ? super.isFile() : named() && brick().isFile(getPath());
    }

    @Override
    public boolean canRead() {
        return brick() == null ? super.canRead() : exists();
    }

    @Override
    public boolean canWrite() {
        return brick() == null ? super.canWrite() : exists();
    }

    @Override
    public boolean canExecute() {
        return brick() == null ? super.canExecute() : isDirectory();
    }

    @Override
    public boolean isHidden() {
        return brick() == null ? super.isHidden() : getName().startsWith(".");
    }

    @Override
    public long length() {
        return brick() == null ? super.length() : brick().length(getPath());
    }

    @Override
    public long lastModified() {
        return brick() == null ? super.lastModified() : brick().modifiedMillis(getPath());
    }

    @Override
    public boolean setLastModified(long millis) {
        if (millis < 0) {
            throw new IllegalArgumentException("Negative time");
        }
        return brick() == null ? super.setLastModified(millis)
                : succeeds(() -> brick().setModifiedMillis(getPath(), millis));
    }

    @Override
    public boolean createNewFile() throws IOException {
        if (brick() == null) {
            return super.createNewFile();
        }
        try {
            brick().createFile(getPath());
            return true;
        } catch (FileAlreadyExistsException there) {
            return false;
        } catch (FileSystemException impossible) {
            throw new IOException(impossible.getReason() == null ? "No such file or directory"
                    : impossible.getReason());
        }
    }

    @Override
    public boolean delete() {
        return brick() == null ? super.delete() : named() && succeeds(() -> brick().delete(getPath()));
    }

    @Override
    public void deleteOnExit() {
        if (brick() == null) {
            super.deleteOnExit();
        } else {
            brick().deleteAtEnd(getPath());
        }
    }

    @Override
    public boolean mkdir() {
        return brick() == null ? super.mkdir() : succeeds(() -> brick().createFolder(getPath()));
    }

    @Override
    public boolean mkdirs() {
        if (brick() == null) {
            return super.mkdirs();
        }
        File parent = getAbsoluteFile().getParentFile();
        return !exists() && parent != null && (parent.isDirectory() || parent.mkdirs()) && mkdir();
    }

    @Override
    public boolean renameTo(File target) {
        return brick() == null ? super.renameTo(target)
                : succeeds(() -> brick().move(getPath(), target.getPath(), !target.isDirectory()));
    }

    @Override
    public String[] list() {
        if (brick() == null) {
            return super.list();
        }
        try {
            return brick().list(getPath()).toArray(new String[0]);
        } catch (FileSystemException noFolder) {
            return null;
        }
    }

    @Override
    public String[] list(FilenameFilter filter) {
        String[] names = list();
        if (names == null || filter == null) {
            return names;
        }
        List<String> accepted = new ArrayList<>();
        for (String name : names) {
            if (filter.accept(this, name)) {
                accepted.add(name);
            }
        }
        return accepted.toArray(new String[0]);
    }

    @Override
    public File[] listFiles() {
        return listFiles((FilenameFilter) null);
    }

    @Override
    public File[] listFiles(FilenameFilter filter) {
        String[] names = list(filter);
        if (names == null) {
            return null;
        }
        File[] files = new File[names.length];
        for (int i = 0; i < names.length; i++) {
            files[i] = new ProgramFile(this, names[i]);
        }
        return files;
    }

    @Override
    public File[] listFiles(FileFilter filter) {
        return listFiles((folder, name) -> filter == null || filter.accept(new ProgramFile(folder, name)));
    }

    @Override
    public boolean setReadOnly() {
        return brick() == null ? super.setReadOnly() : exists();
    }

    @Override
    public boolean setWritable(boolean writable, boolean ownerOnly) {
        return brick() == null ? super.setWritable(writable, ownerOnly) : exists();
    }

    @Override
    public boolean setReadable(boolean readable, boolean ownerOnly) {
        return brick() == null ? super.setReadable(readable, ownerOnly) : exists();
    }

    @Override
    public boolean setExecutable(boolean executable, boolean ownerOnly) {
        return brick() == null ? super.setExecutable(executable, ownerOnly) : exists();
    }

    @Override
    public long getTotalSpace() {
        return brick() == null ? super.getTotalSpace() : BrickFiles.CAPACITY_BYTES;
    }

    @Override
    public long getFreeSpace() {
        return brick() == null ? super.getFreeSpace() : brick().freeBytes();
    }

    @Override
    public long getUsableSpace() {
        return brick() == null ? super.getUsableSpace() : brick().freeBytes();
    }

    /** {@code File.listRoots}. */
    public static File[] listRoots() {
        return brick() == null ? File.listRoots() : new File[] {new ProgramFile("/")};
    }

    /** {@code File.createTempFile}. */
    public static File createTempFile(String prefix, String suffix) throws IOException {
        return createTempFile(prefix, suffix, null);
    }

    /** {@code File.createTempFile}: on a brick the names are counted. */
    public static File createTempFile(String prefix, String suffix, File folder) throws IOException {
        if (brick() == null) {
            return of(File.createTempFile(prefix, suffix, folder));
        }
        if (prefix.length() < 3) {
            throw new IllegalArgumentException("Prefix string \"" + prefix + "\" too short: length must be at least 3");
        }
        File parent = folder == null ? new ProgramFile(PropertyHooks.getProperty("java.io.tmpdir")) : folder;
        File file = new ProgramFile(parent, FileHooks.temporaryName(prefix, suffix == null ? ".tmp" : suffix));
        if (!file.createNewFile()) {
            throw new IOException("Unable to create temporary file, " + file);
        }
        return file;
    }
}
