package brickless.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.TreeMap;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.testkit.engine.Event;
import org.junit.platform.testkit.engine.Events;

/** How each of some tests ended, by the name of its method; invocations of a template end in {@code #1}, {@code #2}. */
final class CaseResults {
    private final Map<String, TestExecutionResult> results = new TreeMap<>();

    CaseResults(Events events) {
        events.finished().stream().forEach(
                event -> results.put(name(event), event.getRequiredPayload(TestExecutionResult.class)));
    }

    private static String name(Event event) {
        String id = event.getTestDescriptor().getUniqueId().getLastSegment().getValue();
        if (!id.startsWith("#")) {
            return withoutParameters(id);
        }
        return withoutParameters(event.getTestDescriptor().getParent().orElseThrow().getDisplayName()) + id;
    }

    private static String withoutParameters(String method) {
        return method.replaceAll("\\(.*", "");
    }

    /** What a test that failed threw. */
    Throwable failure(String name) {
        assertThat(results).containsKey(name);
        return results.get(name).getThrowable().orElseThrow(() -> new AssertionError(name + " passed"));
    }

    void assertPassed(String... names) {
        for (String name : names) {
            assertThat(results).containsKey(name);
            assertThat(results.get(name).getThrowable()).as(name).isEmpty();
        }
    }
}
