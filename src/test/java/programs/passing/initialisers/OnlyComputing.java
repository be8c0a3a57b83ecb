package programs.passing.initialisers;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.function.IntUnaryOperator;

/**
 * Initialisers that only compute run at the first use, whatever that is: reflection with primitive values, a method
 * handle, a method reference, an inherited method, the constants of an enum.
 *
 * @expected exited 0
 * @prints 3 7 9 4 5.5 [Lprograms.passing.initialisers.OnlyComputing$ByName;
 * @prints EAST NORTH 2
 */
public class OnlyComputing {
    static class ByReflection {
        static int value = Integer.parseInt("3");
    }

    static class ByHandle {
        private static final int[] TABLE = {5, 6, 7};

        static int third() {
            return TABLE[2];
        }
    }

    static class ByReference {
        private static final int[] SQUARES = {0, 1, 4, 9};

        static int square(int value) {
            return SQUARES[value];
        }
    }

    static class Parent {
        private static final int[] TWICE = {0, 2, 4};

        static int twice(int value) {
            return TWICE[value];
        }
    }

    static class Child extends Parent {
    }

    static class BySetting {
        static double value = Double.parseDouble("1.5");
    }

    static class ByName {
    }

    enum Heading {
        NORTH, EAST, SOUTH;

        private static final Heading[] RIGHT = {EAST, SOUTH, NORTH};

        Heading right() {
            return RIGHT[ordinal()];
        }
    }

    public static void main(String[] args) throws Throwable {
        int reflected = ByReflection.class.getDeclaredField("value").getInt(null);
        int handled = (int) MethodHandles.lookup()
                .findStatic(ByHandle.class, "third", MethodType.methodType(int.class)).invoke();
        IntUnaryOperator square = ByReference::square;
        BySetting.class.getDeclaredField("value").setDouble(null, 5.5);
        System.out.println(reflected + " " + handled + " " + square.applyAsInt(3) + " " + Child.twice(2) + " "
                + BySetting.value + " " + Class.forName("[L" + ByName.class.getName() + ";").getName());
        System.out.println(Enum.valueOf(Heading.class, "NORTH").right() + " " + Heading.valueOf("SOUTH").right() + " "
                + Heading.class.getEnumConstants()[2].ordinal());
    }
}
