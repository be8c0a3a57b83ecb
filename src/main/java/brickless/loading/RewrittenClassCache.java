package brickless.loading;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;

/**
 * Rewritten bytes, shared by all robots and runs of the JVM: leJOS and a program that runs again need no second
 * rewriting.
 *
 * <p>The key is the class file's content; an entry also remembers what the rewriting learned about other classes, and
 * fits only where the same is true. Bounded: the least recently used entries go first. Holds no class and no loader.
 * Thread-safe.
 */
final class RewrittenClassCache {
    private static final RewrittenClassCache SHARED = new RewrittenClassCache(64L << 20);

    private final long capacityBytes;
    private final Map<String, Entry> entries = new LinkedHashMap<>(16, 0.75f, true);
    private long storedBytes;
    private long hits;

    RewrittenClassCache(long capacityBytes) {
        this.capacityBytes = capacityBytes;
    }

    /** The JVM's cache. */
    static RewrittenClassCache shared() {
        return SHARED;
    }

    /** The key of a class file's content. */
    static String key(byte[] classFile) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(classFile));
        } catch (NoSuchAlgorithmException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /**
     * The rewritten class, or null if unknown here.
     *
     * @param summaries what is true now about other classes
     */
    RewrittenClass find(String key, Function<String, ClassSummary> summaries) {
        Entry entry;
        synchronized (this) {
            entry = entries.get(key);
        }
        if (entry == null) {
            return null;
        }
        for (Map.Entry<String, ClassSummary> learned : entry.learned.entrySet()) {
            if (!Objects.equals(summaries.apply(learned.getKey()), learned.getValue())) {
                return null;
            }
        }
        synchronized (this) {
            hits++;
        }
        return entry.rewritten;
    }

    /** Stores the class under a key, with what the rewriting learned about other classes. */
    synchronized void store(String key, RewrittenClass rewritten, Map<String, ClassSummary> learned) {
        Entry previous = entries.put(key, new Entry(rewritten, learned));
        storedBytes += rewritten.size() - (previous == null ? 0 : previous.rewritten.size());
        Iterator<Entry> eldest = entries.values().iterator();
        while (storedBytes > capacityBytes && eldest.hasNext()) {
            storedBytes -= eldest.next().rewritten.size();
            eldest.remove();
        }
    }

    /** How often stored classes were used. */
    synchronized long hits() {
        return hits;
    }

    private record Entry(RewrittenClass rewritten, Map<String, ClassSummary> learned) {}
}
