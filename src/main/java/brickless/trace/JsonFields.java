package brickless.trace;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;

/** The fields of one JSON object that was read; what is missing or of another type is an error that names the field. */
public final class JsonFields {
    /** Programs print lines as long as they like. */
    private static final JsonFactory FACTORY = JsonFactory.builder()
            .streamReadConstraints(StreamReadConstraints.builder().maxStringLength(Integer.MAX_VALUE).build()).build();

    private final Map<String, Object> values;

    private JsonFields(Map<String, Object> values) {
        this.values = values;
    }

    /**
     * Reads one object.
     *
     * @throws IllegalArgumentException if the text is not exactly one JSON object; the message says what is wrong
     */
    public static JsonFields parse(String text) {
        try (JsonParser parser = FACTORY.createParser(text)) {
            if (parser.nextToken() != JsonToken.START_OBJECT) {
                throw new IllegalArgumentException("is no JSON object");
            }
            JsonFields fields = object(parser);
            if (parser.nextToken() != null) {
                throw new IllegalArgumentException("holds more than one JSON object");
            }
            return fields;
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("is no JSON object, or is cut off: " + e.getOriginalMessage().lines()
                    .findFirst().orElse(""), e);
        } catch (IOException e) {
            throw new IllegalStateException("text cannot fail to be read", e);
        }
    }

    private static JsonFields object(JsonParser parser) throws IOException {
        Map<String, Object> values = new LinkedHashMap<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
            String name = parser.currentName();
            parser.nextToken();
            values.put(name, value(parser));
        }
        return new JsonFields(values);
    }

    private static Object value(JsonParser parser) throws IOException {
        return switch (parser.currentToken()) {
            case START_OBJECT -> object(parser);
            case START_ARRAY -> array(parser);
            case VALUE_STRING -> parser.getText();
            case VALUE_TRUE -> Boolean.TRUE;
            case VALUE_FALSE -> Boolean.FALSE;
            case VALUE_NUMBER_INT -> parser.getLongValue();
            case VALUE_NUMBER_FLOAT -> parser.getDoubleValue();
            default -> null;
        };
    }

    private static List<Object> array(JsonParser parser) throws IOException {
        List<Object> items = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
            items.add(value(parser));
        }
        return items;
    }

    /** Names of the fields, in the order of the text. */
    public Set<String> names() {
        return Collections.unmodifiableSet(values.keySet());
    }

    /** Whether the field is there and not {@code null}. */
    public boolean has(String name) {
        return values.get(name) != null;
    }

    /** Whether the field is a string. */
    public boolean isText(String name) {
        return values.get(name) instanceof String;
    }

    /** A string. */
    public String text(String name) {
        return of(name, String.class, "a string", values.get(name));
    }

    /** An object. */
    public JsonFields object(String name) {
        return of(name, JsonFields.class, "an object", values.get(name));
    }

    /** A whole number. */
    public long integer(String name) {
        return of(name, Long.class, "a whole number", values.get(name));
    }

    /** A number; {@code null} gives NaN, as numbers that are not finite are written so. */
    public double number(String name) {
        if (!values.containsKey(name)) {
            throw missing(name);
        }
        return number(name, values.get(name));
    }

    private static double number(String name, Object value) {
        return value == null ? Double.NaN : of(name, Number.class, "a number", value).doubleValue();
    }

    /** Seconds, as nanoseconds. */
    public long nanos(String name) {
        double seconds = number(name);
        if (!(Math.abs(seconds) < 1e9)) {
            throw new IllegalArgumentException("field \"" + name + "\" is no time in seconds");
        }
        return Math.round(seconds * 1e6) * 1_000;
    }

    /** A boolean. */
    public boolean flag(String name) {
        return of(name, Boolean.class, "true or false", values.get(name));
    }

    /** An array of strings. */
    public List<String> texts(String name) {
        return items(name, item -> of(name, String.class, "an array of strings", item));
    }

    /** An array of whole numbers. */
    public List<Integer> integers(String name) {
        return items(name, item -> Math.toIntExact(of(name, Long.class, "an array of whole numbers", item)));
    }

    /** An array of numbers; {@code null} gives NaN. */
    public double[] numbers(String name) {
        return items(name, item -> number(name, item)).stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** An array of objects; none if the field is missing. */
    public List<JsonFields> objects(String name) {
        return has(name) ? items(name, item -> of(name, JsonFields.class, "an array of objects", item)) : List.of();
    }

    private <T> List<T> items(String name, Function<Object, T> item) {
        List<T> items = new ArrayList<>();
        for (Object value : of(name, List.class, "an array", values.get(name))) {
            items.add(item.apply(value));
        }
        return items;
    }

    private static <T> T of(String name, Class<T> type, String expected, Object value) {
        if (value == null) {
            throw missing(name);
        }
        if (!type.isInstance(value)) {
            throw new IllegalArgumentException("field \"" + name + "\" is not " + expected);
        }
        return type.cast(value);
    }

    private static IllegalArgumentException missing(String name) {
        return new IllegalArgumentException("field \"" + name + "\" is missing");
    }
}
