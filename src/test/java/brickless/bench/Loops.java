package brickless.bench;

/** Loops as programs compute in them; each returns something that depends on all its work. */
public final class Loops {
    /** Turns of the loop in {@link #turns}. */
    public static final int TURNS = 5_000_000;
    private static final int SIZE = 120;

    private Loops() {}

    /** A loop that does next to nothing. */
    public static double turns() {
        int value = 1;
        for (int i = 0; i < TURNS; i++) {
            value = value * 31 + i;
        }
        return value;
    }

    /** Matrix product: three nested loops over arrays. */
    public static double matrix() {
        double[][] a = new double[SIZE][SIZE];
        double[][] b = new double[SIZE][SIZE];
        double[][] c = new double[SIZE][SIZE];
        for (int i = 0; i < SIZE; i++) {
            for (int j = 0; j < SIZE; j++) {
                a[i][j] = i - j;
                b[i][j] = i + 2 * j;
            }
        }
        for (int i = 0; i < SIZE; i++) {
            for (int j = 0; j < SIZE; j++) {
                double sum = 0;
                for (int k = 0; k < SIZE; k++) {
                    sum += a[i][k] * b[k][j];
                }
                c[i][j] = sum;
            }
        }
        return c[SIZE / 2][SIZE / 3];
    }

    /** Sieve of Eratosthenes. */
    public static double sieve() {
        boolean[] composite = new boolean[400_000];
        int primes = 0;
        for (int i = 2; i < composite.length; i++) {
            if (!composite[i]) {
                primes++;
                for (long j = (long) i * i; j < composite.length; j += i) {
                    composite[(int) j] = true;
                }
            }
        }
        return primes;
    }

    /** Longest Collatz sequence: integer arithmetic with a branch. */
    public static double collatz() {
        int longest = 0;
        for (int start = 1; start < 20_000; start++) {
            int length = 0;
            for (long n = start; n != 1; n = n % 2 == 0 ? n / 2 : 3 * n + 1) {
                length++;
            }
            longest = Math.max(longest, length);
        }
        return longest;
    }

    /** Moving particles: objects, fields, floating point and library calls. */
    public static double particles() {
        double[] x = new double[200];
        double[] weight = new double[200];
        for (int step = 0; step < 200; step++) {
            double sum = 0;
            for (int i = 0; i < x.length; i++) {
                x[i] += Math.sqrt(i + step) * 0.01;
                weight[i] = 1 / (1 + x[i] * x[i]);
                sum += weight[i];
            }
            for (int i = 0; i < x.length; i++) {
                weight[i] /= sum;
            }
        }
        return weight[7];
    }

    /** Recursion: nothing but small calls. */
    public static double fibonacci() {
        return fibonacci(27);
    }

    private static int fibonacci(int n) {
        return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2);
    }

    /** Bubble sort: compare and swap. */
    public static double sort() {
        int[] values = new int[1_500];
        for (int i = 0; i < values.length; i++) {
            values[i] = i * 7919 % 1_501;
        }
        for (int end = values.length - 1; end > 0; end--) {
            for (int i = 0; i < end; i++) {
                if (values[i] > values[i + 1]) {
                    int swap = values[i];
                    values[i] = values[i + 1];
                    values[i + 1] = swap;
                }
            }
        }
        return values[700];
    }
}
