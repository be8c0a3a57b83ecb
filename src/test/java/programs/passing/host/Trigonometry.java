package programs.passing.host;

/**
 * Functions of {@code Math} that may differ by a last digit between processors are those of {@code StrictMath}.
 *
 * @expected exited 0
 * @prints alike
 */
public class Trigonometry {
    public static void main(String[] args) {
        int differences = 0;
        for (int i = 1; i < 3000; i++) {
            double x = i / 7.0;
            boolean alike = Math.sin(x) == StrictMath.sin(x) && Math.cos(x) == StrictMath.cos(x)
                    && Math.tan(x) == StrictMath.tan(x) && Math.exp(x / 9) == StrictMath.exp(x / 9)
                    && Math.log(x) == StrictMath.log(x) && Math.log10(x) == StrictMath.log10(x)
                    && Math.pow(x, 1.7) == StrictMath.pow(x, 1.7) && Math.atan2(x, 3) == StrictMath.atan2(x, 3)
                    && Math.asin(1 / x) == StrictMath.asin(1 / x) | x < 1;
            differences += alike ? 0 : 1;
        }
        System.out.println(differences == 0 ? "alike" : differences + " differ");
    }
}
