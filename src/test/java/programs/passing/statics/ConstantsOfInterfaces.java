package programs.passing.statics;

import java.lang.invoke.MethodHandles;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntSupplier;

/**
 * Computed constants of interfaces: of every kind, inherited, made with lambdas and methods of the interface, and found
 * by reflection.
 *
 * @expected exited 0
 * @prints interface initialised
 * @prints 1 5 6 [first, second] 7 8 9
 * @prints 2 3.5 [first, second] 2
 * @prints final
 */
public class ConstantsOfInterfaces {
    interface Ports {
        int FIXED = 1;
        int[] COMPUTED = {made(), 6};
        List<String> NAMES = new ArrayList<>();
        IntSupplier SEVEN = () -> helper() + 5;
        double REAL = made() - 1.5;
        int TWO = COMPUTED.length;

        static int made() {
            if (Flags.first) {
                Flags.first = false;
                System.out.println("interface initialised");
            }
            return 5;
        }

        private static int helper() {
            return 2;
        }

        default int eight() {
            return SEVEN.getAsInt() + FIXED;
        }
    }

    interface MorePorts extends Ports {
        int NINE = COMPUTED[0] + 4;
    }

    static class Flags {
        static boolean first = true;
    }

    static class Robot implements MorePorts {
        String all() {
            NAMES.add("first");
            pause();
            NAMES.add("second");
            return FIXED + " " + COMPUTED[0] + " " + Robot.COMPUTED[1] + " " + MorePorts.NAMES + " " + SEVEN.getAsInt()
                    + " " + eight() + " " + NINE;
        }
    }

    static void pause() {
        try {
            Thread.sleep((long) (Math.random() * 10));
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    public static void main(String[] args) throws Throwable {
        pause();
        System.out.println(new Robot().all());
        pause();
        System.out.println(Ports.class.getField("TWO").getInt(null) + " " + MorePorts.class.getField("REAL")
                .getDouble(null) + " " + Robot.class.getField("NAMES").get(null) + " "
                + MethodHandles.lookup().findStaticGetter(Ports.class, "TWO", int.class).invoke());
        try {
            Ports.class.getField("TWO").setInt(null, 3);
            System.out.println("changed");
        } catch (IllegalAccessException e) {
            System.out.println("final");
        }
    }
}
