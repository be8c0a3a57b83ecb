package brickless.world.svg;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.world.DescriptionException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Thousands of damaged drawings: each is read or refused with one line, never anything else. A failing index reproduces
 * itself.
 */
class MutationsTest {
    private static final String[] SPLINTERS = {"\"", "<", ">", "&", "/", "-", "1e9", "0", "NaN", "-1", "1e-300",
            "url(#", "#", "none", "M", "Z", "A", " ", "\n",
        "data-solid=\"fixed\"", "data-solid=\"movable\"", "data-zone=\"z\"", "data-edge=\"cliff\"", "data-beacon=\"1\"",
                "transform=\"scale(0)\"", "scale(1e6)",
        "rotate(17)", "%", "}", "{", "<use href=\"#a\"/>", "<g>", "</g>", "]]>", "<!--", "\u0000", "\uD800", "é",
                "stroke-dasharray=\"1 2 3\"", "fill=\"none\""};
    private static final int MUTANTS_PER_SLICE = 2_500;
    private static final List<String> SEEDS = seeds();

    private static List<String> seeds() {
        List<String> texts = new ArrayList<>();
        try {
            for (Path path : Stream.concat(Shipped.worlds().stream(), Shipped.robots().stream()).toList()) {
                texts.add(Files.readString(path));
            }
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        texts.removeIf(text -> text.length() > 5_000);
        texts.add("<svg viewBox='0 0 90 90'><defs><g id='a'><path d='M1 2 C3 4 5 6 7 8 S1 2 3 4 Q1 2 3 4 T9 9 A5 6 "
                + "30 0 1 20 20z'/></g>"
                + "<linearGradient id='l'><stop offset='.2' "
                        + "stop-color='red'/></linearGradient></defs><style>.s{fill:url(#l);stroke:rgb(1,2,3)}</style>"
                + "<use href='#a' x='3' class='s' data-solid='movable'/><path data-solid='fixed' fill-rule='evenodd' "
                        + "d='M0,0h60v60h-60z M9,9h30v30h-30z'/>"
                + "<image width='20' height='10' "
                        + "href='data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVQI"
                + "12P4z8AAAAMBAQAY3Y2wAAAAAElFTkSuQmCC'/></svg>");
        return texts;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void damagedTextIsReadOrRefused(int slice) {
        int refused = 0;
        for (int i = 0; i < MUTANTS_PER_SLICE; i++) {
            int index = slice * MUTANTS_PER_SLICE + i;
            refused += attempt(index, mutant(index)) ? 0 : 1;
        }
        assertThat(refused).as("some survive, some do not")
                .isBetween(MUTANTS_PER_SLICE / 10, MUTANTS_PER_SLICE * 99 / 100);
    }

    private static String mutant(int index) {
        Random random = new Random(index);
        StringBuilder text = new StringBuilder(SEEDS.get(random.nextInt(SEEDS.size())));
        for (int n = 1 + random.nextInt(3); n > 0; n--) {
            int at = random.nextInt(text.length());
            switch (random.nextInt(5)) {
                case 0 -> text.insert(at, SPLINTERS[random.nextInt(SPLINTERS.length)]);
                case 1 -> text.delete(at, Math.min(text.length(), at + 1 + random.nextInt(12)));
                case 2 -> text.setCharAt(at, (char) (32 + random.nextInt(95)));
                case 3 -> digit(text, at, random);
                default -> {
                    int from = random.nextInt(text.length());
                    text.insert(at, text.substring(from, Math.min(text.length(), from + random.nextInt(60))));
                }
            }
        }
        return text.toString();
    }

    /** Changes the next digit, which mostly leaves the file well-formed. */
    private static void digit(StringBuilder text, int from, Random random) {
        for (int i = from; i < text.length(); i++) {
            if (Character.isDigit(text.charAt(i))) {
                text.replace(i, i + 1, random.nextBoolean() ? String.valueOf(random.nextInt(10))
                        : SPLINTERS[random.nextInt(SPLINTERS.length)]);
                return;
            }
        }
    }

    /** True if the text could be read. */
    private static boolean attempt(int index, String text) {
        try {
            if (text.contains("data-part")) {
                SvgRobotReader.readText("mutant.svg", text);
            } else {
                SvgWorldReader.readText("mutant.svg", text);
            }
            return true;
        } catch (DescriptionException e) {
            assertThat(e.getMessage()).as("mutant " + index).startsWith("mutant.svg").doesNotContain("\n");
            return false;
        } catch (RuntimeException | StackOverflowError e) {
            throw new AssertionError("mutant " + index + ":\n" + text, e);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void damagedBytesAreReadOrRefused(int slice) {
        for (int i = 0; i < 300; i++) {
            int index = slice * 300 + i;
            Random random = new Random(index);
            byte[] bytes = SEEDS.get(random.nextInt(SEEDS.size())).getBytes(StandardCharsets.UTF_8);
            for (int n = 0; n < 3; n++) {
                bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
            }
            try {
                attempt(index, SourceText.decode("mutant.svg", bytes));
            } catch (DescriptionException e) {
                assertThat(e.getMessage()).as("mutant " + index).doesNotContain("\n");
            }
        }
    }
}
