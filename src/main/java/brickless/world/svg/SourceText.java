package brickless.world.svg;

import brickless.world.DescriptionException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Bytes of a drawing to text, by byte order mark, else XML declaration, else UTF-8. */
final class SourceText {
    private static final Pattern DECLARATION = Pattern.compile(
            "^<\\?xml[^>]{0,200}?encoding\\s*=\\s*[\"']([A-Za-z0-9._-]{1,40})[\"']");
    private static final Map<String, Charset> CHARSETS = Map.of(
            "utf-8", StandardCharsets.UTF_8, "us-ascii", StandardCharsets.US_ASCII, "iso-8859-1",
                    StandardCharsets.ISO_8859_1);

    private SourceText() {}

    static String read(Path path) throws DescriptionException {
        byte[] bytes;
        try (InputStream in = Files.newInputStream(path)) {
            bytes = in.readNBytes(Limits.FILE_BYTES + 1);
        } catch (NoSuchFileException e) {
            throw new DescriptionException(path.toString(), 0, "", "no such file");
        } catch (IOException e) {
            throw new DescriptionException(path.toString(), 0, "", "cannot be read as a file");
        }
        if (bytes.length > Limits.FILE_BYTES) {
            throw new DescriptionException(path.toString(), 0, "", "larger than " + (Limits.FILE_BYTES >> 20) + " MiB");
        }
        return decode(path.toString(), bytes);
    }

    static String decode(String file, byte[] bytes) throws DescriptionException {
        Charset charset = charset(file, bytes);
        try {
            String text = charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
            return text.startsWith("\uFEFF") ? text.substring(1) : text;
        } catch (CharacterCodingException e) {
            throw new DescriptionException(file, 0, "", "is not valid " + charset.name() + " text");
        }
    }

    private static Charset charset(String file, byte[] bytes) throws DescriptionException {
        if (bytes.length >= 2 && ((bytes[0] & 0xFF) == 0xFE && (bytes[1] & 0xFF) == 0xFF
                || (bytes[0] & 0xFF) == 0xFF && (bytes[1] & 0xFF) == 0xFE)) {
            return StandardCharsets.UTF_16;
        }
        String start = new String(bytes, 0, Math.min(bytes.length, 300), StandardCharsets.ISO_8859_1);
        Matcher declared = DECLARATION.matcher(start);
        String name = declared.find() ? declared.group(1).toLowerCase(Locale.ROOT) : "utf-8";
        Charset charset = CHARSETS.get(name);
        if (charset == null) {
            throw new DescriptionException(file, 1, "", "encoding \"" + name
                    + "\" is not supported; allowed: UTF-8, UTF-16, ISO-8859-1, US-ASCII");
        }
        return charset;
    }
}
