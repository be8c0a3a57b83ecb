package brickless.world.svg;

import java.util.Base64;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Puts the images that lie beside a drawing into its text, so that the text alone shows the whole drawing. Lines keep
 * their numbers.
 */
final class EmbeddedImages {
    private static final Pattern IMAGE = Pattern.compile(
            "<(?:\\w+:)?image\\b[^<>]*?\\bhref\\s*=\\s*([\"'])(?!data:|#)([^\"']*)\\1");

    private EmbeddedImages() {}

    /** The drawing's text; an image that cannot be read stays a reference. */
    static String textOf(SvgDocument document) {
        StringBuilder text = new StringBuilder();
        Matcher image = IMAGE.matcher(document.text());
        int done = 0;
        while (image.find()) {
            text.append(document.text(), done, image.start(2)).append(embedded(document, image.group(2)));
            done = image.end(2);
        }
        return text.append(document.text(), done, document.text().length()).toString();
    }

    private static String embedded(SvgDocument document, String href) {
        try {
            byte[] bytes = ImageSource.beside(document, href.strip().replace("&amp;", "&"));
            String type = bytes.length > 1 && bytes[0] == (byte) 0xFF && bytes[1] == (byte) 0xD8 ? "jpeg" : "png";
            return "data:image/" + type + ";base64," + Base64.getEncoder().encodeToString(bytes);
        } catch (MalformedValueException e) {
            // Only an image that nothing shows, as inside an unused definition, gets here: the others were read when
            // the drawing was.
            return href;
        }
    }
}
