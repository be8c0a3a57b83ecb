package brickless.trace;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.List;

/** Parts that pages are joined from: plain files among the resources, named by their path below {@code /brickless/}. */
public final class PageParts {
    private static final String ROOT = "/brickless/";

    private PageParts() {}

    /** Text of one part. */
    public static String text(String path) {
        try (InputStream in = PageParts.class.getResourceAsStream(ROOT + path)) {
            if (in == null) {
                throw new IllegalStateException(ROOT + path + " is missing from the brickless jar");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException(ROOT + path + " cannot be read from the brickless jar", e);
        }
    }

    /** Parts one after the other. */
    public static String joined(List<String> paths) {
        StringBuilder text = new StringBuilder();
        for (String path : paths) {
            text.append(text(path)).append('\n');
        }
        return text.toString();
    }

    /** Scripts joined into one that leaves no names behind; those behind may use those before. */
    public static String script(List<String> paths) {
        return "'use strict';\n(() => {\n" + joined(paths) + "})();\n";
    }

    /** How a content policy names a script: {@code sha256-…}. */
    public static String hash(String script) {
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(script.getBytes(StandardCharsets.UTF_8));
            return "sha256-" + Base64.getEncoder().encodeToString(hash);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }

    /** Text that means itself in HTML. */
    public static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;");
    }
}
