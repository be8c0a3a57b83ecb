package brickless.trace;

import com.fasterxml.jackson.core.JsonEncoding;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.OutputStream;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.function.Consumer;

/** Makes one-line JSON objects. */
public final class JsonText {
    private static final JsonFactory FACTORY = new JsonFactory();

    private JsonText() {}

    /** Text of one object whose fields {@code fields} writes. */
    public static String object(Consumer<JsonLine> fields) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = FACTORY.createGenerator(text)) {
            json.writeStartObject();
            fields.accept(new JsonLine(json));
            json.writeEndObject();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return text.toString();
    }

    /** Text of an array of two numbers with a fixed number of decimals. */
    public static String pair(double first, double second, int places) {
        return "[" + Decimals.text(first, places) + "," + Decimals.text(second, places) + "]";
    }

    /** Writes one object whose fields {@code fields} writes, in UTF-8; the stream is left open. */
    static void object(OutputStream out, Consumer<JsonLine> fields) throws IOException {
        try (JsonGenerator json = FACTORY.createGenerator(out, JsonEncoding.UTF8)) {
            json.disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET);
            json.writeStartObject();
            fields.accept(new JsonLine(json));
            json.writeEndObject();
        }
    }
}
