package brickless.world.svg;

import brickless.world.DescriptionException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * The rules of {@code <style>} elements: selectors {@code tag}, {@code .class}, {@code #id}, {@code *} and combinations
 * such as {@code rect.wall}.
 */
final class StyleSheet {
    private static final Pattern SIMPLE = Pattern.compile("(\\*|[A-Za-z][\\w-]*)?([.#][\\w-]+)*");

    private record Rule(String tag, Set<String> classes, Set<String> ids, Map<String, String> declarations) {
        int specificity() {
            return ids.size() * 10_000 + classes.size() * 100 + (tag.isEmpty() ? 0 : 1);
        }

        boolean matches(SvgElement element, Set<String> elementClasses) {
            return (tag.isEmpty() || tag.equals(element.name())) && elementClasses.containsAll(classes)
                    && (ids.isEmpty() || ids.equals(Set.of(element.id())));
        }
    }

    private final List<Rule> rules = new ArrayList<>();

    static StyleSheet of(SvgDocument document) throws DescriptionException {
        StyleSheet sheet = new StyleSheet();
        sheet.collect(document, document.root());
        sheet.rules.sort(Comparator.comparingInt(Rule::specificity));
        return sheet;
    }

    /** Declarations of an element, weakest first applied: presentation attributes are not included. */
    Map<String, String> declarations(SvgElement element) {
        if (rules.isEmpty()) {
            return Map.of();
        }
        Set<String> classes = Set.of(classNames(element.attributes().getOrDefault("class", "")));
        Map<String, String> found = new LinkedHashMap<>();
        for (Rule rule : rules) {
            if (rule.matches(element, classes)) {
                found.putAll(rule.declarations());
            }
        }
        return found;
    }

    /** Reads {@code name: value; …}. */
    static Map<String, String> parseDeclarations(String text) {
        Map<String, String> found = new LinkedHashMap<>();
        int start = 0;
        while (start < text.length()) {
            int end = semicolon(text, start);
            int colon = text.indexOf(':', start);
            if (colon > start && colon < end) {
                String value = text.substring(colon + 1, end).replace("!important", "").strip();
                found.put(text.substring(start, colon).strip(), value);
            }
            start = end + 1;
        }
        return found;
    }

    /** Position of the semicolon that ends a declaration; those inside parentheses (data: addresses) do not. */
    private static int semicolon(String text, int from) {
        int depth = 0;
        for (int i = from; i < text.length(); i++) {
            char c = text.charAt(i);
            depth += c == '(' ? 1 : c == ')' ? -1 : 0;
            if (c == ';' && depth <= 0) {
                return i;
            }
        }
        return text.length();
    }

    private void collect(SvgDocument document, SvgElement element) throws DescriptionException {
        if (element.name().equals("style")) {
            String css = withoutComments(element.text());
            try {
                parse(css);
            } catch (MalformedValueException e) {
                throw document.error(element, e.getMessage());
            }
        }
        for (SvgElement child : element.children()) {
            collect(document, child);
        }
    }

    private void parse(String css) throws MalformedValueException {
        int position = 0;
        while (position < css.length()) {
            int open = css.indexOf('{', position);
            int semicolon = css.indexOf(';', position);
            if (css.substring(position).strip().startsWith("@") && semicolon >= 0 && (open < 0 || semicolon < open)) {
                position = semicolon + 1;
                continue;
            }
            if (open < 0) {
                if (!css.substring(position).isBlank()) {
                    throw new MalformedValueException("style: { is missing after \""
                            + LengthParser.shortened(css.substring(position).strip()) + "\"");
                }
                return;
            }
            int close = closing(css, open);
            rule(css.substring(position, open).strip(), css.substring(open + 1, close));
            position = close + 1;
        }
    }

    private static int closing(String css, int open) throws MalformedValueException {
        int depth = 0;
        for (int i = open; i < css.length(); i++) {
            depth += css.charAt(i) == '{' ? 1 : css.charAt(i) == '}' ? -1 : 0;
            if (depth == 0) {
                return i;
            }
        }
        throw new MalformedValueException("style: } is missing");
    }

    private void rule(String selectors, String body) throws MalformedValueException {
        if (selectors.startsWith("@")) {
            return;
        }
        Map<String, String> declarations = parseDeclarations(body);
        for (String selector : selectors.split(",")) {
            String simple = selector.strip();
            if (simple.contains(":")) {
                continue;
            }
            if (simple.isEmpty() || !SIMPLE.matcher(simple).matches()) {
                throw new MalformedValueException("style: the selector \"" + LengthParser.shortened(simple)
                        + "\" is not supported; allowed: tag, .class, #id, * and combinations such as rect.wall");
            }
            rules.add(rule(simple, declarations));
        }
    }

    private static Rule rule(String selector, Map<String, String> declarations) {
        String[] parts = selector.split("(?=[.#])");
        Set<String> classes = new TreeSet<>();
        Set<String> ids = new TreeSet<>();
        String tag = "";
        for (String part : parts) {
            if (part.startsWith(".")) {
                classes.add(part.substring(1));
            } else if (part.startsWith("#")) {
                ids.add(part.substring(1));
            } else if (!part.equals("*")) {
                tag = part;
            }
        }
        return new Rule(tag, classes, ids, declarations);
    }

    private static String[] classNames(String classAttribute) {
        return classAttribute.isBlank() ? new String[0]
                : Arrays.stream(classAttribute.strip().split("\\s+")).distinct().toArray(String[]::new);
    }

    private static String withoutComments(String css) {
        StringBuilder clean = new StringBuilder();
        int from = 0;
        for (int open = css.indexOf("/*"); open >= 0; open = css.indexOf("/*", from)) {
            clean.append(css, from, open);
            int close = css.indexOf("*/", open + 2);
            from = close < 0 ? css.length() : close + 2;
        }
        return clean.append(css.substring(from)).toString();
    }
}
