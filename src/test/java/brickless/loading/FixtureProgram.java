package brickless.loading;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A program under {@code src/test/java/programs} and what its comment says must happen:
 *
 * <pre>
 * &#64;expected exited 0          outcome, then exit status or class of the exception
 * &#64;limit 5 s                  virtual time limit (default 10 s)
 * &#64;input text                 a line of System.in
 * &#64;prints text                a line of output; all of them, in order, are the whole output
 * &#64;contains text              the output or the dump has it somewhere
 * &#64;outside                    the host's network decides about times, so only the output is the same in every run
 * &#64;explore 200 deadlock       one of 200 random schedules ends like this
 * &#64;schedules 40               so do 40 random schedules, with the same output
 * </pre>
 */
record FixtureProgram(String mainClass, String expected, long limitSeconds, String input, List<String> prints,
        List<String> contains,
        boolean outside, String explore, int schedules) {
    /** Every program with a main method below {@code programs/passing} and {@code programs/failing}. */
    static List<FixtureProgram> all() throws IOException {
        Path sources = sources();
        try (Stream<Path> files = Files.walk(sources.resolve("programs"))) {
            List<FixtureProgram> programs = new ArrayList<>();
            for (Path file : files.filter(path -> path.toString().endsWith(".java")
                    && tellsItsEnd(sources.relativize(path))).sorted().collect(Collectors.toList())) {
                String text = Files.readString(file, StandardCharsets.UTF_8);
                if (text.contains("void main(String")) {
                    String name = sources.relativize(file).toString().replace('\\', '/').replace('/', '.');
                    programs.add(parse(name.substring(0, name.length() - ".java".length()), text));
                }
            }
            return programs;
        }
    }

    private static boolean tellsItsEnd(Path program) {
        return program.startsWith("programs/passing") || program.startsWith("programs/failing");
    }

    /** The test sources of the project in or below which the tests run. */
    private static Path sources() {
        for (Path folder = Path.of("").toAbsolutePath(); folder != null; folder = folder.getParent()) {
            Path sources = folder.resolve("src/test/java");
            if (Files.isDirectory(sources.resolve("programs"))) {
                return sources;
            }
        }
        throw new IllegalStateException("src/test/java/programs not found: run the tests in the project's folder");
    }

    private static FixtureProgram parse(String mainClass, String text) {
        List<String> expected = tags(text, "expected");
        if (expected.size() != 1) {
            throw new IllegalStateException(mainClass + " needs exactly one @expected");
        }
        String limit = tags(text, "limit").stream().findFirst().orElse("10 s");
        String input = tags(text, "input").stream().map(line -> line + "\n").collect(Collectors.joining());
        return new FixtureProgram(mainClass, expected.get(0), Long.parseLong(limit.replace(" s", "")), input,
                tags(text, "prints"),
                tags(text, "contains"), !tags(text, "outside").isEmpty(),
                tags(text, "explore").stream().findFirst().orElse(null),
                Integer.parseInt(tags(text, "schedules").stream().findFirst().orElse("0")));
    }

    private static List<String> tags(String text, String tag) {
        String comment = text.substring(text.indexOf("/**"), text.indexOf("*/"));
        return comment.lines().map(line -> line.replaceFirst("^\\s*\\* ?", ""))
                .filter(line -> line.startsWith("@" + tag))
                .map(line -> line.substring(Math.min(line.length(), tag.length() + 2))).collect(Collectors.toList());
    }
}
