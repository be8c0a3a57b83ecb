package brickless.files;

import java.util.TreeMap;

/** A folder; its listing is in the order of names. */
final class Folder extends Entry {
    final TreeMap<String, Entry> entries = new TreeMap<>();

    Folder(long modifiedMillis) {
        super(modifiedMillis);
    }
}
