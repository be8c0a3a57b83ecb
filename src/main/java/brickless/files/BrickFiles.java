package brickless.files;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.LongSupplier;

/**
 * The files of one robot's brick in one run, in memory.
 *
 * <p>Paths are written as on the brick; relative ones begin in {@link #WORKING_FOLDER}. Like root on the brick the
 * program may do everything. Nothing blocks or takes simulated time. What fails is told in the terms of {@code
 * java.nio.file}, with the path as the program wrote it.
 */
public final class BrickFiles {
    /** Where programs lie and relative names begin. */
    public static final String WORKING_FOLDER = "/home/lejos/programs";
    /**
     * Room for what a program writes. Assumption: more than any measured program needs, little enough for many runs.
     */
    public static final long CAPACITY_BYTES = 64L << 20;

    private static final List<String> FOLDERS = List.of(WORKING_FOLDER, "/home/lejos/lib", "/home/lejos/samples",
            "/home/root/lejos", "/tmp");

    private final long startMillis;
    private final LongSupplier clockMillis;
    private final Card card = new Card(CAPACITY_BYTES);
    private final Folder root;
    private final BrickFileSystem fileSystem = new BrickFileSystem(this);
    private final Set<String> deletedAtEnd = new LinkedHashSet<>();
    private int temporaryNames;

    /**
     * An empty brick.
     *
     * @param startMillis what the program's clock shows at its start: the date of what is on the brick then
     * @param clockMillis the program's clock, asked while the program runs
     */
    public BrickFiles(long startMillis, LongSupplier clockMillis) {
        this.startMillis = startMillis;
        this.clockMillis = clockMillis;
        root = new Folder(startMillis);
        FOLDERS.forEach(this::makeFolders);
    }

    long nowMillis() {
        return clockMillis.getAsLong();
    }

    /** The same files for {@code java.nio.file}. */
    public FileSystem fileSystem() {
        return fileSystem;
    }

    /** A path for {@code java.nio.file}. */
    public Path path(String path) {
        return BrickPath.of(fileSystem, path);
    }

    /** The path behind the working folder if it is relative, else as it is. */
    public static String absolute(String path) {
        return Names.absolute(path);
    }

    /** The one absolute path of a file, without {@code .} and {@code ..}. */
    public static String canonical(String path) {
        return Names.canonical(path);
    }

    /**
     * Puts a file of the host, of at most {@link #CAPACITY_BYTES}, on the brick before the program starts; missing
     * folders are made.
     */
    public void put(String path, Path original, long sizeBytes) {
        List<String> names = Names.fromRoot(path);
        Folder folder = makeFolders("/" + String.join("/", names.subList(0, names.size() - 1)));
        Content content = Content.of(original, Math.toIntExact(sizeBytes), card, startMillis);
        folder.entries.put(names.get(names.size() - 1), content);
    }

    private Folder makeFolders(String path) {
        Folder folder = root;
        for (String name : Names.fromRoot(path)) {
            folder = (Folder) folder.entries.computeIfAbsent(name, absent -> new Folder(startMillis));
        }
        return folder;
    }

    private Entry find(String path) {
        return find(Names.fromRoot(path));
    }

    private Entry find(List<String> names) {
        Entry entry = root;
        for (String name : names) {
            entry = entry instanceof Folder ? ((Folder) entry).entries.get(name) : null;
        }
        return entry;
    }

    private Entry existing(String path) throws FileSystemException {
        Entry entry = find(path);
        if (entry == null) {
            throw new NoSuchFileException(path);
        }
        return entry;
    }

    /** The folder that holds, or would hold, a file. */
    private Folder parent(String path) throws FileSystemException {
        List<String> names = Names.fromRoot(path);
        Entry parent = names.isEmpty() ? root : find(names.subList(0, names.size() - 1));
        if (parent == null) {
            throw new NoSuchFileException(path);
        }
        if (!(parent instanceof Folder)) {
            throw new FileSystemException(path, null, "Not a directory");
        }
        return (Folder) parent;
    }

    private static String name(String path) {
        List<String> names = Names.fromRoot(path);
        return names.isEmpty() ? "" : names.get(names.size() - 1);
    }

    /** Whether there is a file or a folder. */
    public boolean exists(String path) {
        return find(path) != null;
    }

    /** Whether there is a folder. */
    public boolean isFolder(String path) {
        return find(path) instanceof Folder;
    }

    /** Whether there is a file. */
    public boolean isFile(String path) {
        return find(path) instanceof Content;
    }

    /** Length of a file in bytes; 0 for folders and missing files. */
    public long length(String path) {
        Entry entry = find(path);
        return entry instanceof Content ? ((Content) entry).size() : 0;
    }

    /** Time of the last change in milliseconds of the program's clock; 0 for missing files. */
    public long modifiedMillis(String path) {
        Entry entry = find(path);
        return entry == null ? 0 : entry.modifiedMillis;
    }

    /** Sets the time of the last change. */
    public void setModifiedMillis(String path, long millis) throws FileSystemException {
        existing(path).modifiedMillis = millis;
    }

    /** Room that is left, in bytes. */
    public long freeBytes() {
        return card.freeBytes();
    }

    /** Names of what a folder holds, sorted. */
    public List<String> list(String path) throws FileSystemException {
        Entry entry = existing(path);
        if (!(entry instanceof Folder)) {
            throw new NotDirectoryException(path);
        }
        return List.copyOf(((Folder) entry).entries.keySet());
    }

    /** Makes a folder in an existing one. */
    public void createFolder(String path) throws FileSystemException {
        add(path, new Folder(nowMillis()));
    }

    /** Makes an empty file. */
    public void createFile(String path) throws FileSystemException {
        add(path, Content.empty(card, nowMillis()));
    }

    private void add(String path, Entry entry) throws FileSystemException {
        Folder parent = parent(path);
        if (find(path) != null) {
            throw new FileAlreadyExistsException(path);
        }
        parent.entries.put(name(path), entry);
        parent.modifiedMillis = nowMillis();
    }

    /** Deletes a file or an empty folder. */
    public void delete(String path) throws FileSystemException {
        Entry entry = existing(path);
        if (entry == root || entry instanceof Folder && !((Folder) entry).entries.isEmpty()) {
            throw new DirectoryNotEmptyException(path);
        }
        if (entry instanceof Content) {
            ((Content) entry).delete();
        }
        remove(path);
    }

    private void remove(String path) throws FileSystemException {
        Folder parent = parent(path);
        parent.entries.remove(name(path));
        parent.modifiedMillis = nowMillis();
    }

    /** Deletes a file when the program is over. */
    public void deleteAtEnd(String path) {
        deletedAtEnd.add(canonical(path));
    }

    /** The program is over. */
    public void end() {
        List<String> last = new ArrayList<>(deletedAtEnd);
        for (int i = last.size() - 1; i >= 0; i--) {
            List<String> names = Names.fromRoot(last.get(i));
            Entry entry = find(names);
            if (entry instanceof Content || entry instanceof Folder && ((Folder) entry).entries.isEmpty()) {
                unlink(names, entry);
            }
        }
        deletedAtEnd.clear();
    }

    /** Copies a file, or makes an empty folder like that one. */
    public void copy(String from, String to, boolean replace) throws IOException {
        Entry entry = existing(from);
        if (entry == find(to)) {
            return;
        }
        makeRoom(to, replace);
        add(to, entry instanceof Content ? ((Content) entry).copy(nowMillis()) : new Folder(nowMillis()));
    }

    /** Moves a file or a folder with all it holds. */
    public void move(String from, String to, boolean replace) throws IOException {
        Entry entry = existing(from);
        if (entry == find(to)) {
            return;
        }
        if ((canonical(to) + "/").startsWith(canonical(from) + "/")) {
            throw new FileSystemException(from, to, "Invalid argument");
        }
        parent(to);
        makeRoom(to, replace);
        changeAll(entry);
        remove(from);
        add(to, entry);
    }

    private void makeRoom(String path, boolean replace) throws FileSystemException {
        if (replace && find(path) != null) {
            delete(path);
        }
    }

    /** Under another name a file is one that the program made. */
    private static void changeAll(Entry entry) throws IOException {
        if (entry instanceof Content) {
            ((Content) entry).change();
        } else {
            for (Entry child : ((Folder) entry).entries.values()) {
                changeAll(child);
            }
        }
    }

    /**
     * Opens a file.
     *
     * @param options as in {@link FileChannel#open(Path, OpenOption...)}
     */
    public FileChannel open(String path, Set<? extends OpenOption> options) throws IOException {
        OpenMode mode = OpenMode.of(options);
        Entry entry = find(path);
        if (entry == null && (mode.creates() || mode.createsNew())) {
            entry = Content.empty(card, nowMillis());
            add(path, entry);
        } else if (entry == null) {
            throw new NoSuchFileException(path);
        } else if (mode.createsNew()) {
            throw new FileAlreadyExistsException(path);
        }
        if (!(entry instanceof Content)) {
            throw new FileSystemException(path, null, "Is a directory");
        }
        Content content = (Content) entry;
        if (mode.truncates()) {
            content.resize(0);
            content.modifiedMillis = nowMillis();
        }
        return new BrickFileChannel(this, content, mode, mode.deletesAtClose()
                ? () -> unlink(Names.fromRoot(path), content) : () -> { });
    }

    private void unlink(List<String> names, Entry entry) {
        if (!names.isEmpty() && find(names) == entry) {
            Folder parent = (Folder) find(names.subList(0, names.size() - 1));
            parent.entries.remove(names.get(names.size() - 1));
            if (entry instanceof Content) {
                ((Content) entry).delete();
            }
        }
    }

    /** A number for the name of a temporary file: 1, 2, 3 … */
    public int nextTemporaryNumber() {
        return ++temporaryNames;
    }

    /** All bytes of a file. */
    public byte[] read(String path) throws IOException {
        Entry entry = existing(path);
        if (entry instanceof Folder) {
            throw new FileSystemException(path, null, "Is a directory");
        }
        return ((Content) entry).bytes();
    }

    /** Canonical paths and lengths of the files that the program made or changed, sorted. */
    public SortedMap<String, Integer> written() {
        SortedMap<String, Integer> written = new TreeMap<>();
        collect("", root, written);
        return written;
    }

    private static void collect(String path, Entry entry, SortedMap<String, Integer> written) {
        if (entry instanceof Folder) {
            ((Folder) entry).entries.forEach((name, child) -> collect(path + "/" + name, child, written));
        } else if (((Content) entry).changed()) {
            written.put(path, ((Content) entry).size());
        }
    }
}
