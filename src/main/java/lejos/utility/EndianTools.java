package lejos.utility;

/** Numbers as bytes, most (BE) or least (LE) significant byte first. Only the array's own bounds are checked. */
public class EndianTools {
    private static final int LONG = Long.BYTES;
    private static final int INT = Integer.BYTES;
    private static final int SHORT = Short.BYTES;

    /** Creates an object nobody needs: all methods are static. */
    public EndianTools() {}

    private static long decodeBE(byte[] b, int off, int count) {
        long value = 0;
        for (int i = 0; i < count; i++) {
            value = value << Byte.SIZE | b[off + i] & 0xff;
        }
        return value;
    }

    private static long decodeLE(byte[] b, int off, int count) {
        long value = 0;
        for (int i = count - 1; i >= 0; i--) {
            value = value << Byte.SIZE | b[off + i] & 0xff;
        }
        return value;
    }

    private static void encodeBE(long v, byte[] b, int off, int count) {
        for (int i = 0; i < count; i++) {
            b[off + i] = (byte) (v >> Byte.SIZE * (count - 1 - i));
        }
    }

    private static void encodeLE(long v, byte[] b, int off, int count) {
        for (int i = 0; i < count; i++) {
            b[off + i] = (byte) (v >> Byte.SIZE * i);
        }
    }

    /** Eight bytes, signed. */
    public static long decodeLongBE(byte[] b, int off) {
        return decodeBE(b, off, LONG);
    }

    /** Four bytes, unsigned. */
    public static long decodeUIntBE(byte[] b, int off) {
        return decodeBE(b, off, INT);
    }

    /** Two bytes, unsigned. */
    public static int decodeUShortBE(byte[] b, int off) {
        return (int) decodeBE(b, off, SHORT);
    }

    /** Four bytes, signed. */
    public static int decodeIntBE(byte[] b, int off) {
        return (int) decodeBE(b, off, INT);
    }

    /** Two bytes, signed. */
    public static short decodeShortBE(byte[] b, int off) {
        return (short) decodeBE(b, off, SHORT);
    }

    /** Eight bytes, signed. */
    public static long decodeLongLE(byte[] b, int off) {
        return decodeLE(b, off, LONG);
    }

    /** Four bytes, unsigned. */
    public static long decodeUIntLE(byte[] b, int off) {
        return decodeLE(b, off, INT);
    }

    /** Two bytes, unsigned. */
    public static int decodeUShortLE(byte[] b, int off) {
        return (int) decodeLE(b, off, SHORT);
    }

    /** Four bytes, signed. */
    public static int decodeIntLE(byte[] b, int off) {
        return (int) decodeLE(b, off, INT);
    }

    /** Two bytes, signed. */
    public static short decodeShortLE(byte[] b, int off) {
        return (short) decodeLE(b, off, SHORT);
    }

    /** Eight bytes. */
    public static void encodeLongBE(long v, byte[] b, int off) {
        encodeBE(v, b, off, LONG);
    }

    /** Four bytes. */
    public static void encodeIntBE(int v, byte[] b, int off) {
        encodeBE(v, b, off, INT);
    }

    /** The lowest two bytes of a number. */
    public static void encodeShortBE(int v, byte[] b, int off) {
        encodeBE(v, b, off, SHORT);
    }

    /** Eight bytes. */
    public static void encodeLongLE(long v, byte[] b, int off) {
        encodeLE(v, b, off, LONG);
    }

    /** Four bytes. */
    public static void encodeIntLE(int v, byte[] b, int off) {
        encodeLE(v, b, off, INT);
    }

    /** The lowest two bytes of a number. */
    public static void encodeShortLE(int v, byte[] b, int off) {
        encodeLE(v, b, off, SHORT);
    }
}
