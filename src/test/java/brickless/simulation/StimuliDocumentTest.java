package brickless.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.world.DescriptionException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** {@code sim/docs/STIMULI.md} says what is true. */
class StimuliDocumentTest {
    private static final Pattern EXAMPLE = Pattern.compile("<!-- stimuli -->\n```\n(.*?)```", Pattern.DOTALL);

    private static String document() throws IOException {
        return Files.readString(Path.of(System.getProperty("brickless.home"), "sim/docs/STIMULI.md"));
    }

    @Test
    void everyLineOfTheExamplesIsAStimulus() throws IOException, DescriptionException {
        List<Integer> sizes = new ArrayList<>();
        Matcher examples = EXAMPLE.matcher(document());
        while (examples.find()) {
            List<Stimulus> stimuli = StimuliReader.readText("example", examples.group(1));
            assertThat(stimuli).hasSize((int) examples.group(1).lines().count());
            sizes.add(stimuli.size());
        }
        assertThat(sizes).containsExactly(10, 3);
    }

    @Test
    void theExamplesHoldEveryKindOfStimulus() throws IOException, DescriptionException {
        List<Class<?>> kinds = new ArrayList<>();
        Matcher examples = EXAMPLE.matcher(document());
        while (examples.find()) {
            StimuliReader.readText("example", examples.group(1)).forEach(stimulus -> kinds.add(stimulus.getClass()));
        }
        assertThat(kinds).contains(Stimulus.class.getPermittedSubclasses());
    }
}
