package brickless.trace;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;

/** One flat JSON object being written; fields appear in the order of the calls. */
public final class JsonLine {
    private final JsonGenerator json;

    JsonLine(JsonGenerator json) {
        this.json = json;
    }

    /** Writes a string. */
    public JsonLine text(String name, String value) {
        return write(() -> json.writeStringField(name, value));
    }

    /** Writes a whole number. */
    public JsonLine integer(String name, long value) {
        return write(() -> json.writeNumberField(name, value));
    }

    /** Writes a number with a fixed number of decimals; {@code null} if it is not finite. */
    public JsonLine number(String name, double value, int places) {
        return write(() -> {
            json.writeFieldName(name);
            json.writeRawValue(Decimals.text(value, places));
        });
    }

    /** Writes nanoseconds as seconds. */
    public JsonLine seconds(String name, long nanos) {
        return write(() -> {
            json.writeFieldName(name);
            json.writeRawValue(Decimals.seconds(nanos));
        });
    }

    /** Writes a boolean. */
    public JsonLine flag(String name, boolean value) {
        return write(() -> json.writeBooleanField(name, value));
    }

    /** Writes a null. */
    public JsonLine nothing(String name) {
        return write(() -> json.writeNullField(name));
    }

    /** Writes an array of strings. */
    public JsonLine texts(String name, List<String> values) {
        return write(() -> {
            json.writeArrayFieldStart(name);
            for (String value : values) {
                json.writeString(value);
            }
            json.writeEndArray();
        });
    }

    /** Writes an array of whole numbers. */
    public JsonLine integers(String name, List<Integer> values) {
        return write(() -> {
            json.writeArrayFieldStart(name);
            for (int value : values) {
                json.writeNumber(value);
            }
            json.writeEndArray();
        });
    }

    /** Writes an array of objects, one per item. */
    public <T> JsonLine objects(String name, Iterable<T> items, java.util.function.BiConsumer<T, JsonLine> fields) {
        return write(() -> {
            json.writeArrayFieldStart(name);
            for (T item : items) {
                json.writeStartObject();
                fields.accept(item, this);
                json.writeEndObject();
            }
            json.writeEndArray();
        });
    }

    /** Writes a nested object. */
    public JsonLine object(String name, Runnable fields) {
        return write(() -> {
            json.writeObjectFieldStart(name);
            fields.run();
            json.writeEndObject();
        });
    }

    /** Writes a value that is JSON already. */
    public JsonLine raw(String name, String value) {
        return write(() -> {
            json.writeFieldName(name);
            json.writeRawValue(value);
        });
    }

    private interface Writing {
        void run() throws IOException;
    }

    private JsonLine write(Writing writing) {
        try {
            writing.run();
            return this;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
