package brickless.files;

import java.nio.file.OpenOption;
import java.nio.file.StandardOpenOption;
import java.util.Set;

/** What a file is opened for. */
record OpenMode(boolean reads, boolean writes, boolean appends, boolean truncates, boolean creates, boolean createsNew,
        boolean deletesAtClose) {
    /**
     * The mode that options ask for.
     *
     * @throws IllegalArgumentException if they contradict each other
     */
    static OpenMode of(Set<? extends OpenOption> options) {
        boolean appends = options.contains(StandardOpenOption.APPEND);
        boolean writes = appends || options.contains(StandardOpenOption.WRITE);
        boolean truncates = writes && options.contains(StandardOpenOption.TRUNCATE_EXISTING);
        if (appends && (truncates || options.contains(StandardOpenOption.READ))) {
            throw new IllegalArgumentException("APPEND goes neither with READ nor with TRUNCATE_EXISTING");
        }
        return new OpenMode(!writes || options.contains(StandardOpenOption.READ), writes, appends, truncates,
                writes && options.contains(StandardOpenOption.CREATE),
                writes && options.contains(StandardOpenOption.CREATE_NEW),
                options.contains(StandardOpenOption.DELETE_ON_CLOSE));
    }
}
