package programs.passing.statics;

import java.util.function.Supplier;

/**
 * Every robot initialises its classes itself and in order: parents first, singletons when asked for, failures again and
 * again.
 *
 * @expected exited 0
 * @prints base
 * @prints child of base 1
 * @prints asked
 * @prints holder made
 * @prints the one
 * @prints the one
 * @prints java.lang.ExceptionInInitializerError java.lang.ArithmeticException: / by zero
 * @prints Could not initialize class programs.passing.statics.InitialisedInOrder$Broken
 * @prints Could not initialize class programs.passing.statics.InitialisedInOrder$Broken
 * @prints 4 6
 * @prints 8 from the parent
 */
public class InitialisedInOrder {
    static class Base {
        static int count = say("base") + 1;
    }

    static class Child extends Base {
        static final String NAME = "child of base " + count;
    }

    static class Singleton {
        private static Singleton one;

        static Singleton one() {
            if (one == null) {
                one = Holder.MADE;
            }
            return one;
        }

        @Override
        public String toString() {
            return "the one";
        }

        static class Holder {
            static final Singleton MADE = made();

            static Singleton made() {
                say("holder made");
                return new Singleton();
            }
        }
    }

    static class Broken {
        static int value = 1 / zero();

        static int zero() {
            return 0;
        }
    }

    static class BelowBroken extends Broken {
    }

    /** Only computes. */
    static class Table {
        static final int[] SQUARES = new int[10];

        static {
            for (int i = 0; i < SQUARES.length; i++) {
                SQUARES[i] = i * i;
            }
        }

        static int root(int square) {
            return SQUARES[square / 2];
        }
    }

    static class Inherits extends Table {
        static int own = SQUARES[2] + 2;
    }

    static class Later extends Table {
        static Object value = "from the parent";
    }

    static int say(String text) {
        System.out.println(text);
        return 0;
    }

    static void pause() {
        try {
            Thread.sleep((long) (Math.random() * 10));
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    static void attempt(Supplier<Integer> use) {
        pause();
        try {
            say("never " + use.get());
        } catch (ExceptionInInitializerError e) {
            say(e.getClass().getName() + " " + e.getCause());
        } catch (NoClassDefFoundError e) {
            say(e.getMessage());
        }
    }

    public static void main(String[] args) {
        pause();
        say(Child.NAME);
        say("asked");
        pause();
        say(Singleton.one().toString());
        pause();
        say(Singleton.one().toString());
        attempt(() -> Broken.value);
        attempt(() -> Broken.value);
        attempt(() -> new BelowBroken().hashCode());
        say(Table.root(4) + " " + Inherits.own);
        Supplier<Later> later = Later::new;
        pause();
        say(Table.SQUARES[3] - 1 + " " + later.get().value);
    }
}
