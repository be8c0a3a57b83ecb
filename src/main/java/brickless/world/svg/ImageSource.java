package brickless.world.svg;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Base64;

/**
 * Finds the bytes of an image: embedded as data:, or a file in the drawing's folder or below. Nothing else is ever
 * opened.
 */
final class ImageSource {
    private static final String ALLOWED =
            "; allowed: an embedded image (data:) or a PNG or JPEG file beside the drawing";

    private ImageSource() {}

    static ImagePixels load(SvgDocument document, SvgElement element) throws MalformedValueException {
        String href = element.attributes().getOrDefault("href", "");
        if (href.isEmpty()) {
            throw new MalformedValueException("the image has no href" + ALLOWED);
        }
        return ImagePixels.decode(href.startsWith("data:") ? embedded(href) : beside(document, href));
    }

    private static byte[] embedded(String href) throws MalformedValueException {
        int comma = href.indexOf(',');
        if (comma < 0 || !href.substring(0, comma).contains(";base64")) {
            throw new MalformedValueException("the embedded image is not base64" + ALLOWED);
        }
        try {
            return Base64.getMimeDecoder().decode(href.substring(comma + 1).replace("%2B", "+").replace("%2F", "/")
                    .replace("%3D", "="));
        } catch (IllegalArgumentException e) {
            throw new MalformedValueException("the embedded image is not valid base64");
        }
    }

    static byte[] beside(SvgDocument document, String href) throws MalformedValueException {
        if (document.folder().isEmpty()) {
            throw new MalformedValueException("the image \"" + LengthParser.shortened(href)
                    + "\" cannot be found from a drawing that is not a file" + ALLOWED);
        }
        try {
            Path folder = document.folder().get().toRealPath();
            Path path = folder.resolve(href.replace("%20", " "));
            if (href.contains(":") || href.startsWith("/") || href.startsWith("\\") || !path.toRealPath()
                    .startsWith(folder)) {
                throw new MalformedValueException("the image \"" + LengthParser.shortened(href)
                        + "\" lies outside the drawing's folder" + ALLOWED);
            }
            return read(path, href);
        } catch (IOException | InvalidPathException e) {
            throw new MalformedValueException("the image \"" + LengthParser.shortened(href) + "\" cannot be read"
                    + ALLOWED);
        }
    }

    private static byte[] read(Path path, String href) throws IOException, MalformedValueException {
        if (!Files.isRegularFile(path)) {
            throw new MalformedValueException("the image \"" + LengthParser.shortened(href) + "\" is not a file"
                    + ALLOWED);
        }
        try (InputStream in = Files.newInputStream(path)) {
            byte[] bytes = in.readNBytes(Limits.FILE_BYTES + 1);
            if (bytes.length > Limits.FILE_BYTES) {
                throw new MalformedValueException("the image \"" + LengthParser.shortened(href) + "\" is larger than "
                        + (Limits.FILE_BYTES >> 20) + " MiB");
            }
            return bytes;
        }
    }
}
