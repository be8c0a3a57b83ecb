package brickless.world.svg;

/**
 * Line numbers of start tags. XML readers report where a tag ends; people look for where it begins. In well-formed XML
 * without entity expansion the n-th {@code <name} outside comments, CDATA and processing instructions is the n-th
 * element.
 */
final class TagLines {
    private final String text;
    private int position;
    private int line = 1;

    TagLines(String text) {
        this.text = text;
    }

    /** Line, from 1, of the next start tag. */
    int next() {
        while (position < text.length()) {
            char c = text.charAt(position);
            if (c != '<') {
                advance(position + 1);
            } else if (text.startsWith("<!--", position)) {
                skipPast("-->", 4);
            } else if (text.startsWith("<![CDATA[", position)) {
                skipPast("]]>", 9);
            } else if (text.startsWith("<?", position)) {
                skipPast("?>", 2);
            } else if (text.startsWith("</", position) || text.startsWith("<!", position)) {
                advance(position + 2);
            } else {
                int found = line;
                advance(position + 1);
                return found;
            }
        }
        return line;
    }

    private void skipPast(String end, int from) {
        int found = text.indexOf(end, position + from);
        advance(found < 0 ? text.length() : found + end.length());
    }

    private void advance(int to) {
        for (int i = position; i < to; i++) {
            if (text.charAt(i) == '\n') {
                line++;
            }
        }
        position = to;
    }
}
