package brickless.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Sine and cosine have the bits of StrictMath. */
class SineCosineTest {
    private final SineCosine both = new SineCosine();

    private void check(double x) {
        both.of(x);
        if (Double.doubleToRawLongBits(both.sin()) != Double.doubleToRawLongBits(StrictMath.sin(x))
                || Double.doubleToRawLongBits(both.cos()) != Double.doubleToRawLongBits(StrictMath.cos(x))) {
            assertThat(both.sin()).as("sin(%s)", x).isEqualTo(StrictMath.sin(x));
            assertThat(both.cos()).as("cos(%s)", x).isEqualTo(StrictMath.cos(x));
            throw new AssertionError("signs of zeros differ at " + x);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, -0.0, Double.MIN_VALUE, 1e-300, 1e-9, 0.3, 0.785398163397448, 0.7853981633974484, 1, 2.356194490192344, 2.356194490192345,
        3.141592653589793, 1e5, 823549.6, 823549.7, 1e6, 1e22, Double.MAX_VALUE, Double.NaN, Double.POSITIVE_INFINITY})
    void specialAnglesAreAsInStrictMath(double x) {
        check(x);
        check(-x);
    }

    @Test void multiplesOfAQuarterTurnAndTheirNeighboursAreAsInStrictMath() {
        for (int i = 0; i < 20_000; i++) {
            double x = i * (StrictMath.PI / 4);
            double up = x;
            double down = x;
            for (int k = 0; k < 4; k++) {
                check(up);
                check(-down);
                up = Math.nextUp(up);
                down = Math.nextDown(down);
            }
            check((float) x);
            check(Math.nextUp((float) x));
        }
    }

    @Test void anyAnglesAreAsInStrictMath() {
        Random random = new Random(7);
        for (int i = 0; i < 1_000_000; i++) {
            check((random.nextDouble() - 0.5) * (i % 3 == 0 ? 2 : i % 3 == 1 ? 100 : 1.6e6));
            check((random.nextFloat() - 0.5f) * 20);
        }
        for (int i = 0; i < 200_000; i++) {
            check(Double.longBitsToDouble(random.nextLong()));
        }
    }
}
