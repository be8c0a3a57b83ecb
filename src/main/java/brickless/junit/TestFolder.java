package brickless.junit;

import java.lang.reflect.Method;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.extension.ExtensionContext;

/** Where the files of a test's runs go: {@code build/simulations/CLASS.METHOD}, one folder per test and invocation. */
final class TestFolder {
    /** JUnit configuration parameter for another folder than {@code build/simulations}. */
    static final String PARAMETER = "brickless.simulations";

    private static final Path DEFAULT = Path.of("build", "simulations");
    private static final Pattern INVOCATION = Pattern.compile("test-template-invocation:#(\\d+)\\]$");

    private TestFolder() {}

    static Path of(ExtensionContext context) {
        Class<?> type = context.getRequiredTestClass();
        Method method = context.getRequiredTestMethod();
        String name = type.getName().replace('$', '.') + "." + method.getName();
        if (Arrays.stream(type.getDeclaredMethods()).filter(other -> other.getName().equals(method.getName()))
                .count() > 1) {
            name += Arrays.stream(method.getParameterTypes()).map(Class::getSimpleName)
                    .collect(Collectors.joining("-", "-", ""));
        }
        Matcher invocation = INVOCATION.matcher(context.getUniqueId());
        if (invocation.find()) {
            name += "-" + invocation.group(1);
        }
        return context.getConfigurationParameter(PARAMETER).map(Path::of).orElse(DEFAULT).resolve(name);
    }
}
