package programs.passing.text;

/**
 * Stack traces show the program's frames only, and messages no loader identities.
 *
 * @expected exited 0
 * @prints java.lang.IllegalStateException: outer
 * @prints 	at programs.passing.text.Exceptions.outer(Exceptions.java:25)
 * @prints 	at programs.passing.text.Exceptions.main(Exceptions.java:39)
 * @prints Caused by: java.lang.IllegalArgumentException: inner
 * @prints 	at programs.passing.text.Exceptions.inner(Exceptions.java:31)
 * @prints 	at programs.passing.text.Exceptions.outer(Exceptions.java:23)
 * @prints 	at programs.passing.text.Exceptions.main(Exceptions.java:39)
 * @prints main
 * @prints true
 */
public class Exceptions {
    static class Frog {
    }

    static void outer() {
        try {
            inner();
        } catch (IllegalArgumentException e) {
            throw new IllegalStateException("outer", e);
        }
    }

    static void inner() {
        Runnable thrower = new Exceptions()::fail;
        throw new IllegalArgumentException("inner");
    }

    void fail() {
    }

    public static void main(String[] args) {
        try {
            outer();
        } catch (IllegalStateException e) {
            e.printStackTrace();
            System.out.println(e.getStackTrace()[1].getMethodName());
        }
        Object frog = new Frog();
        try {
            System.out.println((Thread) frog);
        } catch (ClassCastException e) {
            System.out.println(e.getMessage().contains("loader 'robot';"));
        }
    }
}
