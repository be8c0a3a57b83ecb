package brickless.kernel.hooks;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Against some 5,300 texts made by JDK 25, which prints the shortest decimals; JDK 17 alone gets hundreds of them
 * wrong.
 */
class FloatingTextTest {
    @Test
    void everyTextIsThatOfJdk25() throws IOException {
        List<String> wrong = new ArrayList<>();
        int count = 0;
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                FloatingTextTest.class.getResourceAsStream("floating-text.txt"), StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                if (!line.startsWith("#")) {
                    count++;
                    check(line, line.split(" "), wrong);
                }
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(count).isGreaterThan(4_000);
    }

    private static void check(String line, String[] words, List<String> wrong) {
        String text = words[0].equals("d")
                ? FloatingText.of(Double.longBitsToDouble(Long.parseUnsignedLong(words[1], 16)))
                : FloatingText.of(Float.intBitsToFloat(Integer.parseUnsignedInt(words[1], 16)));
        if (!text.equals(words[2])) {
            wrong.add(line + " but was " + text);
        }
    }

    @Test
    void specialValuesHaveTheirNames() {
        assertThat(FloatingText.of(Double.NaN)).isEqualTo("NaN");
        assertThat(FloatingText.of(Float.NEGATIVE_INFINITY)).isEqualTo("-Infinity");
        assertThat(FloatingText.of(-0.0)).isEqualTo("-0.0");
    }

    @Test
    void layoutChangesAtAThousandthAndTenMillion() {
        assertThat(FloatingText.of(0.001)).isEqualTo("0.001");
        assertThat(FloatingText.of(9.999e-4)).isEqualTo("9.999E-4");
        assertThat(FloatingText.of(9999999.0)).isEqualTo("9999999.0");
        assertThat(FloatingText.of(1.0e7f)).isEqualTo("1.0E7");
    }
}
