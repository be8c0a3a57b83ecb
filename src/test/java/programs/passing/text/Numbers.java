package programs.passing.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Doubles and floats have one text on every JDK, however they get into it (JDK 17 alone would print 2.0E-3 and others
 * differently).
 *
 * @expected exited 0
 * @prints 2.0E-323 2.0E-323 2.0E-323 2.0E-323 x2.0E-323
 * @prints 1.0E23 1.0E23 2.2250738585072014E-308
 * @prints 1.1E-44 1.1E-44 1.1E-44
 * @prints [2.0E-323, 0.1] [1.1E-44] [2.0E-323]
 * @prints 2.0E-323 and [2.0E-323] and 0.3
 * @prints 12.35 -0.00 1.5 2.0E-323 NaN|true
 * @prints 0.30000000000000004
 * @prints 2.0E-323
 * @prints 3.4028235E38
 */
public class Numbers {
    private static final double TINY = 4 * Double.MIN_VALUE;
    private static final float SMALL = 8 * Float.MIN_VALUE;

    public static void main(String[] args) {
        double tiny = args.length == 0 ? TINY : 0;
        float small = args.length == 0 ? SMALL : 0;
        Object boxed = tiny;
        StringBuilder builder = new StringBuilder("x").append(tiny);
        System.out.println(tiny + " " + Double.toString(tiny) + " " + String.valueOf(tiny) + " " + boxed + " "
                + builder);
        System.out.println(1.0E23 * (args.length + 1) + " " + Double.valueOf(1.0E23)
                .toString() + " " + Double.MIN_NORMAL);
        System.out.println(small + " " + Float.toString(small) + " " + new StringBuilder().insert(0, small));
        List<Object> list = new ArrayList<>();
        list.add(boxed);
        System.out.println(Arrays.toString(new double[] {tiny, 0.1}) + " " + Arrays.toString(new float[] {small}) + " "
                + list);
        System.out.println(boxed.toString() + " and " + list.toString() + " and " + 0.3f);
        System.out.println(String.format("%.2f %.2f %s %s %s|%b", 12.345678, -0.001, 1.5f, tiny, Double.NaN, true));
        System.out.println(0.1 + 0.2 * (args.length + 1));
        System.out.println(boxed);
        System.out.println(Float.MAX_VALUE);
    }
}
