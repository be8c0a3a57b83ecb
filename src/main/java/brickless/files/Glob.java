package brickless.files;

import java.util.regex.PatternSyntaxException;

/** File name patterns such as <code>*.{txt,csv}</code>, as in {@link java.nio.file.FileSystem#getPathMatcher}. */
final class Glob {
    private static final String SPECIAL_IN_REGEX = ".^$+()|\\{}[]*?";

    private final String glob;
    private final StringBuilder regex = new StringBuilder();
    private int at;
    private boolean inGroup;

    private Glob(String glob) {
        this.glob = glob;
    }

    /**
     * The same as a regular expression.
     *
     * @throws PatternSyntaxException if a bracket or group is not closed
     */
    static String regularExpression(String glob) {
        return new Glob(glob).translate();
    }

    private String translate() {
        while (at < glob.length()) {
            next(glob.charAt(at++));
        }
        if (inGroup) {
            throw new PatternSyntaxException("Missing '}'", glob, at);
        }
        return regex.toString();
    }

    private void next(char c) {
        switch (c) {
            case '*':
                star();
                break;
            case '?':
                regex.append("[^/]");
                break;
            case '[':
                bracket();
                break;
            case '{':
                group(true, "(?:");
                break;
            case '}':
                group(false, ")");
                break;
            case ',':
                regex.append(inGroup ? "|" : ",");
                break;
            case '\\':
                literal(at < glob.length() ? glob.charAt(at++) : c);
                break;
            default:
                literal(c);
        }
    }

    private void star() {
        boolean two = at < glob.length() && glob.charAt(at) == '*';
        at += two ? 1 : 0;
        regex.append(two ? ".*" : "[^/]*");
    }

    private void group(boolean opens, String text) {
        if (opens == inGroup) {
            if (opens) {
                throw new PatternSyntaxException("Cannot nest groups", glob, at);
            }
            regex.append("\\}");
            return;
        }
        inGroup = opens;
        regex.append(text);
    }

    private void bracket() {
        int end = glob.indexOf(']', at + 1);
        if (end < 0) {
            throw new PatternSyntaxException("Missing ']'", glob, at);
        }
        String inside = glob.substring(at, end).replace("\\", "\\\\").replace("[", "\\[").replace("&&", "\\&&");
        regex.append("[[^/]&&[").append(inside.startsWith("!") ? "^" + inside.substring(1) : inside).append("]]");
        at = end + 1;
    }

    private void literal(char c) {
        if (SPECIAL_IN_REGEX.indexOf(c) >= 0) {
            regex.append('\\');
        }
        regex.append(c);
    }
}
