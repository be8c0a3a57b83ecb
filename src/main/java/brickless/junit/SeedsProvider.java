package brickless.junit;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.Extension;
import org.junit.jupiter.api.extension.ExtensionConfigurationException;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.TestTemplateInvocationContext;
import org.junit.jupiter.api.extension.TestTemplateInvocationContextProvider;
import org.junit.platform.commons.support.AnnotationSupport;

/** Makes one invocation per seed of a test with {@link Seeds}. */
final class SeedsProvider implements TestTemplateInvocationContextProvider {
    private static final Pattern RANGE = Pattern.compile("(-?\\d{1,18})(?:\\.\\.(-?\\d{1,18}))?");

    @Override
    public boolean supportsTestTemplate(ExtensionContext context) {
        return seeds(context).isPresent();
    }

    @Override
    public Stream<TestTemplateInvocationContext> provideTestTemplateInvocationContexts(
            ExtensionContext context) {
        return parse(seeds(context).orElseThrow().value()).mapToObj(SeedInvocation::new);
    }

    private static Optional<Seeds> seeds(ExtensionContext context) {
        return context.getTestMethod().flatMap(method -> AnnotationSupport.findAnnotation(method, Seeds.class));
    }

    /** The seeds a text names, in its order. */
    static LongStream parse(String text) {
        return Stream.of(text.split(",", -1)).flatMapToLong(part -> {
            Matcher range = RANGE.matcher(part.strip());
            if (!range.matches()) {
                throw new ExtensionConfigurationException("@Seeds: '" + part.strip()
                        + "' is no seed; allowed: 7, 1..20, and lists of them");
            }
            long first = Long.parseLong(range.group(1));
            long last = range.group(2) == null ? first : Long.parseLong(range.group(2));
            if (last < first) {
                throw new ExtensionConfigurationException("@Seeds: '" + part.strip()
                        + "' is empty; the smaller seed comes first");
            }
            return LongStream.rangeClosed(first, last);
        });
    }

    /** One invocation. */
    private record SeedInvocation(long seed) implements TestTemplateInvocationContext {
        @Override
        public String getDisplayName(int invocationIndex) {
            return "seed " + seed;
        }

        @Override
        public List<Extension> getAdditionalExtensions() {
            return List.of((BeforeEachCallback) context -> TestSimulation.of(context).seed(seed));
        }
    }
}
