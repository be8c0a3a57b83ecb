package brickless.kernel.hooks;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The table of redirected JDK calls, {@code jdk-calls.txt} beside this class. Shared, immutable. */
public final class JdkCalls {
    private static final String TABLE = "jdk-calls.txt";
    private static final List<JdkCall> ALL = read();
    private static final Map<String, List<JdkCall>> BY_SIGNATURE = index();

    private JdkCalls() {}

    /** Every line of the table. */
    public static List<JdkCall> all() {
        return ALL;
    }

    /** The lines whose member has this name and descriptor, whatever the owner. */
    public static List<JdkCall> withSignature(String name, String descriptor) {
        return BY_SIGNATURE.getOrDefault(name + descriptor, Collections.emptyList());
    }

    private static List<JdkCall> read() {
        List<JdkCall> calls = new ArrayList<>();
        try (InputStream table = JdkCalls.class.getResourceAsStream(TABLE);
                BufferedReader reader = new BufferedReader(new InputStreamReader(table, StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                if (!line.isBlank() && !line.startsWith("#")) {
                    calls.add(JdkCall.parse(line));
                }
            }
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
        return Collections.unmodifiableList(calls);
    }

    private static Map<String, List<JdkCall>> index() {
        Map<String, List<JdkCall>> index = new HashMap<>();
        for (JdkCall call : ALL) {
            index.computeIfAbsent(call.signature(), key -> new ArrayList<>()).add(call);
        }
        return index;
    }
}
