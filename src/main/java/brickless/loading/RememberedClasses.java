package brickless.loading;

import java.io.IOException;
import java.net.URL;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A class source that can be exchanged for another one, as long as that gives the same answers: it remembers what was
 * asked for and the content of what was found. Questions may come from any thread; {@link #exchange} must not come
 * while others ask.
 */
final class RememberedClasses implements ClassSource {
    private static final String ABSENT = "";

    private final Map<String, String> answers = new ConcurrentHashMap<>();
    private volatile ClassSource source;

    RememberedClasses(ClassSource source) {
        this.source = source;
    }

    @Override
    public ClassFile find(String internalName) {
        ClassFile file = source.find(internalName);
        answers.computeIfAbsent(internalName, name -> content(file));
        return file;
    }

    private static String content(ClassFile file) {
        return file == null ? ABSENT : RewrittenClassCache.key(file.bytes());
    }

    /** Whether another source would have given the same answers to everything that was asked so far. */
    boolean agreesWith(ClassSource other) {
        return answers.entrySet().stream()
                .allMatch(answer -> content(other.find(answer.getKey())).equals(answer.getValue()));
    }

    /** The names that were asked for and found, in a fixed order. */
    List<String> found() {
        List<String> names = new ArrayList<>();
        answers.forEach((name, content) -> {
            if (!content.equals(ABSENT)) {
                names.add(name);
            }
        });
        names.sort(null);
        return names;
    }

    /** Takes what is asked from now on from another source. */
    void exchange(ClassSource other) {
        source = other;
    }

    @Override
    public List<URL> resources(String path) throws IOException {
        return source.resources(path);
    }

    @Override
    public void close() throws IOException {
        source.close();
    }
}
