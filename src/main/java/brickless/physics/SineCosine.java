package brickless.physics;

/**
 * Sine and cosine of an angle together, with the very bits of {@link StrictMath}, which specifies the algorithms of fdlibm: reduction by
 * multiples of π/2 in up to three parts, then one polynomial for each. In contrast to the JDK's own (21 and later) it allocates nothing,
 * and the reduction is done once for both. Constants are fdlibm's (Sun Microsystems, freely distributable).
 */
final class SineCosine {
    /** High words of the largest doubles that need no reduction, and that the reduction here is good for (2^19 · π/2). */
    private static final int QUARTER_PI = 0x3fe921fb;
    private static final int LARGEST = 0x413921fb;
    private static final int TINY = 0x3e400000;
    private static final double TWO_OVER_PI = Double.longBitsToDouble(0x3FE45F306DC9C883L);
    /** π/2 in parts of 33 bits, each with what remains behind it. */
    private static final double[] PART = parts(0x3FF921FB54400000L, 0x3DD0B4611A600000L, 0x3BA3198A2E000000L);
    private static final double[] REST = parts(0x3DD0B4611A626331L, 0x3BA3198A2E037073L, 0x397B839A252049C1L);
    private static final double[] S = parts(0xBFC5555555555549L, 0x3F8111111110F8A6L, 0xBF2A01A019C161D5L, 0x3EC71DE357B1FE7DL,
            0xBE5AE5E68A2B9CEBL, 0x3DE5D93A5ACFD57CL);
    private static final double S1 = S[0];
    private static final double S2 = S[1];
    private static final double S3 = S[2];
    private static final double S4 = S[3];
    private static final double S5 = S[4];
    private static final double S6 = S[5];
    private static final double[] C = parts(0x3FA555555555554CL, 0xBF56C16C16C15177L, 0x3EFA01A019CB1590L, 0xBE927E4F809C52ADL,
            0x3E21EE9EBDB4B1C4L, 0xBDA8FAE9BE8838D4L);
    private static final double C1 = C[0];
    private static final double C2 = C[1];
    private static final double C3 = C[2];
    private static final double C4 = C[3];
    private static final double C5 = C[4];
    private static final double C6 = C[5];
    /** Angles with these high words may lie so close to a multiple of π/2 that one part is not enough. */
    private static final int[] NEAR_MULTIPLES = new int[32];

    static {
        for (int i = 0; i < NEAR_MULTIPLES.length; i++) {
            NEAR_MULTIPLES[i] = high((i + 1) * (StrictMath.PI / 2));
        }
    }

    private double cos;
    private double sin;
    /** The reduced angle and what was lost of it by rounding. */
    private double head;
    private double tail;

    private static double[] parts(long... bits) {
        double[] values = new double[bits.length];
        for (int i = 0; i < bits.length; i++) {
            values[i] = Double.longBitsToDouble(bits[i]);
        }
        return values;
    }

    private static int high(double x) {
        return (int) (Double.doubleToRawLongBits(x) >>> 32);
    }

    double cos() {
        return cos;
    }

    double sin() {
        return sin;
    }

    /** Computes both. */
    SineCosine of(double radians) {
        int size = high(radians) & 0x7fffffff;
        if (size > LARGEST) {
            cos = StrictMath.cos(radians);
            sin = StrictMath.sin(radians);
        } else if (size <= QUARTER_PI) {
            cos = cosine(radians, 0);
            sin = sine(radians, 0);
        } else {
            turn(reduce(radians, size));
        }
        return this;
    }

    /** Sets both from the reduced angle and the number of quarter turns taken away. */
    private void turn(int quarters) {
        double s = sine(head, tail);
        double c = cosine(head, tail);
        switch (quarters & 3) {
            case 0 -> {
                sin = s;
                cos = c;
            }
            case 1 -> {
                sin = c;
                cos = -s;
            }
            case 2 -> {
                sin = -s;
                cos = -c;
            }
            default -> {
                sin = -c;
                cos = s;
            }
        }
    }

    private int reduce(double x, int size) {
        double t = Math.abs(x);
        int n = size < 0x4002d97c ? 1 : (int) (t * TWO_OVER_PI + 0.5);
        double r = t - n * PART[0];
        double w = n * REST[0];
        head = r - w;
        if (n > NEAR_MULTIPLES.length - 1 || size == NEAR_MULTIPLES[n - 1]) {
            for (int part = 1; part < 3 && lost(size) > (part == 1 ? 16 : 49); part++) {
                t = r;
                w = n * PART[part];
                r = t - w;
                w = n * REST[part] - (t - r - w);
                head = r - w;
            }
        }
        tail = r - head - w;
        if (x < 0) {
            head = -head;
            tail = -tail;
            return -n;
        }
        return n;
    }

    /** Leading bits that were lost by cancellation. */
    private int lost(int size) {
        return (size >> 20) - (high(head) >> 20 & 0x7ff);
    }

    private static double sine(double x, double y) {
        if ((high(x) & 0x7fffffff) < TINY) {
            return x;
        }
        double z = x * x;
        double v = z * x;
        double r = S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)));
        return y == 0 ? x + v * (S1 + z * r) : x - (z * (0.5 * y - v * r) - y - v * S1);
    }

    private static double cosine(double x, double y) {
        int size = high(x) & 0x7fffffff;
        if (size < TINY) {
            return 1;
        }
        double z = x * x;
        double r = z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))));
        if (size < 0x3FD33333) {
            return 1 - (0.5 * z - (z * r - x * y));
        }
        double q = size > 0x3fe90000 ? 0.28125 : Double.longBitsToDouble((long) (size - 0x00200000) << 32);
        double half = 0.5 * z - q;
        return 1 - q - (half - (z * r - x * y));
    }
}
