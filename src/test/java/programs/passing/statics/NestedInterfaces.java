package programs.passing.statics;

/**
 * Constants of a nested interface made with private members of the class around it.
 *
 * @expected exited 0
 * @prints 42 [made]
 */
public class NestedInterfaces {
    private static int answer = 42;

    private interface Constants {
        int ANSWER = answer;
        StringBuilder TEXT = made();
    }

    private static StringBuilder made() {
        return new StringBuilder("[made]");
    }

    public static void main(String[] args) {
        System.out.println(Constants.ANSWER + " " + Constants.TEXT);
    }
}
