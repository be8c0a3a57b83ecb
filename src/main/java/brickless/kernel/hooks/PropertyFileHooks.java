package brickless.kernel.hooks;

import java.io.IOException;
import java.io.OutputStream;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Date;
import java.util.Properties;

/**
 * {@code Properties.store} of rewritten code: the same file on every JDK and in every run. The date is the program's,
 * and the entries are in the order of their text.
 */
public final class PropertyFileHooks {
    private static final int ASCII_END = 0x7f;

    private PropertyFileHooks() {}

    /** {@code Properties.store(writer, comments)}. */
    public static void store(Properties properties, Writer out, String comments) throws IOException {
        out.write(text(properties, comments));
        out.flush();
    }

    /** {@code Properties.store(stream, comments)}: other characters than those of ASCII are escaped. */
    public static void store(Properties properties, OutputStream out, String comments) throws IOException {
        StringBuilder escaped = new StringBuilder();
        for (char c : text(properties, comments).toCharArray()) {
            escaped.append(c < ASCII_END ? String.valueOf(c) : "\\u" + String.format("%04X", (int) c));
        }
        out.write(escaped.toString().getBytes(StandardCharsets.ISO_8859_1));
        out.flush();
    }

    private static String text(Properties properties, String comments) throws IOException {
        StringWriter plain = new StringWriter();
        properties.store(plain, comments);
        String[] lines = plain.toString().split("\\R");
        int header = 0;
        while (header < lines.length && (lines[header].startsWith("#") || lines[header].startsWith("!"))) {
            header++;
        }
        lines[header - 1] = "#" + TimeHooks.text(new Date(Hooks.machine().currentTimeMillis()));
        Arrays.sort(lines, header, lines.length);
        return String.join("\n", lines) + "\n";
    }
}
