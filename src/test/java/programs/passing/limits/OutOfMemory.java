package programs.passing.limits;

/**
 * An array that the brick could not hold is refused, and the program can go on.
 *
 * @expected exited 0
 * @prints refused one
 * @prints refused two
 * @prints negative size
 * @prints small ones work
 */
public class OutOfMemory {
    public static void main(String[] args) {
        try {
            System.out.println(new double[100_000_000].length);
        } catch (OutOfMemoryError e) {
            System.out.println("refused one");
        }
        try {
            System.out.println(new int[10_000][10_000].length);
        } catch (OutOfMemoryError e) {
            System.out.println("refused two");
        }
        try {
            System.out.println(new byte[args.length - 1].length);
        } catch (NegativeArraySizeException e) {
            System.out.println("negative size");
        }
        if (new int[1000][100].length + new String[10].length == 1010) {
            System.out.println("small ones work");
        }
    }
}
