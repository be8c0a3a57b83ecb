package lejos.utility;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;

/** Encodes and decodes numbers that the index decides, with whatever classes it is linked with. */
final class EndianDriver {
    private EndianDriver() {}

    static Map<String, Double> play(int index) {
        Random random = new Random(index);
        byte[] b = new byte[16];
        random.nextBytes(b);
        int off = random.nextInt(8);
        Map<String, Double> seen = new LinkedHashMap<>();
        seen.put("longBE", (double) EndianTools.decodeLongBE(b, off));
        seen.put("uintBE", (double) EndianTools.decodeUIntBE(b, off));
        seen.put("ushortBE", (double) EndianTools.decodeUShortBE(b, off));
        seen.put("intBE", (double) EndianTools.decodeIntBE(b, off));
        seen.put("shortBE", (double) EndianTools.decodeShortBE(b, off));
        seen.put("longLE", (double) EndianTools.decodeLongLE(b, off));
        seen.put("uintLE", (double) EndianTools.decodeUIntLE(b, off));
        seen.put("ushortLE", (double) EndianTools.decodeUShortLE(b, off));
        seen.put("intLE", (double) EndianTools.decodeIntLE(b, off));
        seen.put("shortLE", (double) EndianTools.decodeShortLE(b, off));
        EndianTools.encodeLongBE(random.nextLong(), b, 0);
        EndianTools.encodeLongLE(random.nextLong(), b, 8);
        EndianTools.encodeIntBE(random.nextInt(), b, 3);
        EndianTools.encodeIntLE(random.nextInt(), b, 9);
        EndianTools.encodeShortBE(random.nextInt(), b, 1);
        EndianTools.encodeShortLE(random.nextInt(), b, 14);
        for (int i = 0; i < b.length; i++) {
            seen.put("byte " + i, (double) b[i]);
        }
        return seen;
    }
}
