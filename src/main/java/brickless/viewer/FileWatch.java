package brickless.viewer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32C;

/**
 * Which of some files have another content than at first. A file that is saved as it was, or back to it, has not
 * changed. Files are read again only if their time or size differs from the last look. Not thread-safe.
 */
final class FileWatch {
    /** A look at a file; one that is not there, or is just being replaced by an editor, has no size. */
    private record Look(FileTime time, long size, long checksum) {
        static final Look MISSING = new Look(FileTime.fromMillis(0), -1, 0);

        boolean sameContent(Look other) {
            return size == other.size && checksum == other.checksum;
        }
    }

    private final Map<Path, Look> first = new LinkedHashMap<>();
    private final Map<Path, Look> latest = new LinkedHashMap<>();

    /** Looks at the files for the first time. */
    FileWatch(List<Path> files) {
        files.forEach(file -> first.put(file, look(file)));
        latest.putAll(first);
    }

    /** The files whose content differs now. */
    List<Path> changed() {
        latest.replaceAll((file, look) -> look(file));
        return first.keySet().stream().filter(file -> !latest.get(file).sameContent(first.get(file))).toList();
    }

    private Look look(Path file) {
        try {
            BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
            Look before = latest.get(file);
            if (before != null && before.time().equals(attributes.lastModifiedTime())
                    && before.size() == attributes.size()) {
                return before;
            }
            CRC32C checksum = new CRC32C();
            byte[] content = Files.readAllBytes(file);
            checksum.update(content);
            return new Look(attributes.lastModifiedTime(), content.length, checksum.getValue());
        } catch (IOException e) {
            return Look.MISSING;
        }
    }
}
