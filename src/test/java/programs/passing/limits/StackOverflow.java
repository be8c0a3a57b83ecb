package programs.passing.limits;

/**
 * Endless recursion ends at the same depth in every run, and can be caught; afterwards calls work again.
 *
 * @expected exited 0
 * @prints overflow at the same depth true
 * @prints constructors too
 */
public class StackOverflow {
    private static int depth;

    static class Doll {
        final Doll inner;

        Doll() {
            inner = new Doll();
        }
    }

    private static void recurse() {
        depth++;
        recurse();
    }

    private static int overflow() {
        depth = 0;
        try {
            recurse();
        } catch (StackOverflowError e) {
            return depth;
        }
        return -1;
    }

    public static void main(String[] args) {
        int first = overflow();
        System.out.println("overflow at the same depth " + (first > 1000 && first == overflow()));
        try {
            new Doll();
        } catch (StackOverflowError e) {
            System.out.println("constructors too");
        }
    }
}
