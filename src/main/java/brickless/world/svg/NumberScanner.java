package brickless.world.svg;

/**
 * Reads numbers from path data, transforms, point lists: {@code 1-2.5.5e3} is four numbers 1, -2.5, .5e3 … as SVG
 * defines.
 */
final class NumberScanner {
    private final String text;
    private int position;

    NumberScanner(String text) {
        this.text = text;
    }

    boolean atEnd() {
        return position >= text.length();
    }

    char peek() {
        return atEnd() ? '\0' : text.charAt(position);
    }

    char take() {
        return text.charAt(position++);
    }

    int position() {
        return position;
    }

    void skipSpace() {
        while (!atEnd() && isSpace(peek())) {
            position++;
        }
    }

    /** White space with at most one comma. */
    void skipSeparator() {
        skipSpace();
        if (peek() == ',') {
            position++;
            skipSpace();
        }
    }

    boolean numberAhead() {
        char c = peek();
        return c >= '0' && c <= '9' || c == '.' || c == '-' || c == '+';
    }

    double number() throws MalformedValueException {
        int start = position;
        if (peek() == '+' || peek() == '-') {
            position++;
        }
        int digits = digits();
        if (peek() == '.') {
            position++;
            digits += digits();
        }
        if (digits == 0) {
            throw new MalformedValueException("a number is expected at " + quoteFrom(start));
        }
        exponent();
        double value = Double.parseDouble(text.substring(start, position));
        if (!(Math.abs(value) <= Limits.COORDINATE)) {
            throw new MalformedValueException("the number " + text.substring(start, position)
                    + " is out of range; allowed: up to 10000000");
        }
        return value;
    }

    /** A 0 or 1 of an arc command; they may be written without a space. */
    boolean flag() throws MalformedValueException {
        char c = peek();
        if (c != '0' && c != '1') {
            throw new MalformedValueException("an arc flag (0 or 1) is expected at " + quoteFrom(position));
        }
        position++;
        return c == '1';
    }

    /** Letters of a name, lower or upper case. */
    String word() {
        int start = position;
        while (!atEnd() && Character.isLetter(peek())) {
            position++;
        }
        return text.substring(start, position);
    }

    /** The rest of the text. */
    String rest() {
        return text.substring(position);
    }

    String quoteFrom(int start) {
        return start >= text.length() ? "the end" : "\"" + text.substring(start, Math.min(text.length(), start + 12))
                .replaceAll("\\s", " ") + "\"";
    }

    private void exponent() {
        int before = position;
        if (peek() == 'e' || peek() == 'E') {
            position++;
            if (peek() == '+' || peek() == '-') {
                position++;
            }
            if (digits() == 0) {
                position = before;
            }
        }
    }

    private int digits() {
        int start = position;
        while (peek() >= '0' && peek() <= '9') {
            position++;
        }
        return position - start;
    }

    private static boolean isSpace(char c) {
        return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
    }
}
