package lejos;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import lejos.robotics.Transmittable;

/** What objects look like on the wire. */
public final class Bytes {
    private Bytes() {}

    /** Notes each byte that an object writes. */
    public static void note(Agreement.Sightings seen, String label, Transmittable object) {
        note(seen, label, object, 0);
    }

    /** Notes the number of bytes that an object writes, and each byte from one on. */
    public static void note(Agreement.Sightings seen, String label, Transmittable object, int from) {
        byte[] bytes = of(object);
        seen.note(label + " length", bytes.length);
        for (int i = from; i < bytes.length; i++) {
            seen.note(label + " byte " + i, bytes[i]);
        }
    }

    /** Writes one object and reads it into another. */
    public static <T extends Transmittable> T copy(Transmittable from, T to) {
        try {
            to.loadObject(new DataInputStream(new ByteArrayInputStream(of(from))));
            return to;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static byte[] of(Transmittable object) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            object.dumpObject(out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
