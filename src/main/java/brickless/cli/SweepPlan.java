package brickless.cli;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import java.util.stream.Stream;

/** Which runs a sweep makes, in order: worlds as given (those of a pattern by name), and for each all seeds. */
final class SweepPlan {
    private static final Pattern SEEDS = Pattern.compile("(-?\\d{1,18})(?:\\.\\.(-?\\d{1,18}))?");
    private static final int MOST_RUNS = 1_000_000;

    private SweepPlan() {}

    static List<SweepRun> of(List<String> worlds, String seeds) {
        Set<String> names = new LinkedHashSet<>();
        worlds.forEach(world -> names.addAll(expanded(world)));
        List<Long> numbers = numbers(seeds);
        if ((long) names.size() * numbers.size() > MOST_RUNS) {
            throw new UsageException("that are " + (long) names.size() * numbers.size()
                    + " runs; allowed: " + MOST_RUNS);
        }
        List<SweepRun> plan = new ArrayList<>();
        names.forEach(world -> numbers.forEach(seed -> plan.add(new SweepRun(world, seed))));
        return plan;
    }

    private static List<String> expanded(String world) {
        if (!world.matches(".*[*?\\[{].*")) {
            return List.of(world);
        }
        String forward = world.replace('\\', '/');
        int wild = forward.replaceFirst("[*?\\[{].*", "").lastIndexOf('/');
        String folder = wild < 0 ? "" : forward.substring(0, wild + 1);
        int depth = forward.contains("**") ? Integer.MAX_VALUE
                : (int) forward.substring(folder.length()).chars().filter(c -> c == '/').count() + 1;
        try (Stream<Path> files = Files.walk(Path.of(folder), depth)) {
            PathMatcher matcher = FileSystems.getDefault().getPathMatcher("glob:" + forward);
            List<String> found = files.filter(file -> matcher.matches(file) && Files.isRegularFile(file))
                    .map(Path::toString).sorted().toList();
            if (!found.isEmpty()) {
                return found;
            }
        } catch (IOException | InvalidPathException e) {
            throw new UsageException("--worlds " + world + ": the folder cannot be read");
        } catch (PatternSyntaxException e) {
            throw new UsageException("--worlds " + world + ": is no pattern: " + e.getDescription());
        }
        throw new UsageException("--worlds " + world + ": no such files");
    }

    private static List<Long> numbers(String seeds) {
        Set<Long> numbers = new LinkedHashSet<>();
        for (String part : seeds.split(",", -1)) {
            Matcher range = SEEDS.matcher(part.strip());
            if (!range.matches()) {
                throw new UsageException("--seeds " + seeds + ": '" + part
                        + "' is no seed; allowed: 1..100, or 3,7,11..15");
            }
            long first = Long.parseLong(range.group(1));
            long last = range.group(2) == null ? first : Long.parseLong(range.group(2));
            if (last < first || last - first >= MOST_RUNS) {
                throw new UsageException("--seeds " + seeds + ": '" + part + "' is no range of 1 to "
                        + MOST_RUNS + " seeds");
            }
            for (long seed = first; seed <= last; seed++) {
                numbers.add(seed);
            }
        }
        return List.copyOf(numbers);
    }
}
