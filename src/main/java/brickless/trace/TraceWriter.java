package brickless.trace;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * Writes the canonical trace, line by line, and hashes it.
 *
 * <p>The hash is SHA-256 over exactly the bytes of {@code trace.jsonl}, so {@code sha256sum trace.jsonl} gives it
 * again. Not thread-safe: the simulation writes from one thread at a time.
 */
public final class TraceWriter implements AutoCloseable {
    private final OutputStream out;
    private final MessageDigest digest;
    private final SampleLine line = new SampleLine();
    private String hash;

    /** Creates a writer and writes the header line. */
    public TraceWriter(OutputStream out, TraceHeader header) {
        this.out = out;
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
        append(JsonText.object(line -> header.write(line.text("type", "header"))));
    }

    /** Writes an event of one robot. */
    public void event(long timeNanos, String robot, TraceEvent event) {
        append(TraceLine.event(timeNanos, robot, event));
    }

    /** Writes a sample. */
    public void sample(Sample sample) {
        append(line.write(sample));
    }

    private void append(String line) {
        byte[] bytes = (line + "\n").getBytes(StandardCharsets.UTF_8);
        append(ByteBuffer.wrap(bytes));
    }

    private void append(ByteBuffer bytes) {
        digest.update(bytes.array(), 0, bytes.limit());
        try {
            out.write(bytes.array(), 0, bytes.limit());
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write the trace", e);
        }
    }

    /** SHA-256 of everything written, in hexadecimal; nothing may be written afterwards. */
    public String hash() {
        if (hash == null) {
            hash = HexFormat.of().formatHex(digest.digest());
        }
        return hash;
    }

    @Override
    public void close() throws IOException {
        out.close();
    }
}
