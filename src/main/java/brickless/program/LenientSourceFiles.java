package brickless.program;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.ForwardingJavaFileObject;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;

/** Source files as people keep them: UTF-8, with or without byte order mark, else ISO-8859-1. */
final class LenientSourceFiles extends ForwardingJavaFileManager<StandardJavaFileManager> {
    LenientSourceFiles(StandardJavaFileManager files) {
        super(files);
    }

    /** Text of a source file. */
    static String decode(byte[] bytes) {
        try {
            String text = StandardCharsets.UTF_8.newDecoder().onMalformedInput(CodingErrorAction.REPORT)
                    .onUnmappableCharacter(CodingErrorAction.REPORT).decode(ByteBuffer.wrap(bytes)).toString();
            return text.startsWith("\uFEFF") ? text.substring(1) : text;
        } catch (CharacterCodingException notUtf8) {
            return new String(bytes, StandardCharsets.ISO_8859_1);
        }
    }

    List<JavaFileObject> wrap(Iterable<? extends JavaFileObject> files) {
        List<JavaFileObject> wrapped = new ArrayList<>();
        for (JavaFileObject file : files) {
            wrapped.add(file.getKind() == JavaFileObject.Kind.SOURCE ? new LenientSource(file) : file);
        }
        return wrapped;
    }

    @Override
    public Iterable<JavaFileObject> list(JavaFileManager.Location location, String packageName,
            Set<JavaFileObject.Kind> kinds, boolean recurse) throws IOException {
        return wrap(super.list(location, packageName, kinds, recurse));
    }

    @Override
    public String inferBinaryName(JavaFileManager.Location location, JavaFileObject file) {
        return super.inferBinaryName(location, file instanceof LenientSource source ? source.original() : file);
    }

    private static final class LenientSource extends ForwardingJavaFileObject<JavaFileObject> {
        LenientSource(JavaFileObject file) {
            super(file);
        }

        JavaFileObject original() {
            return fileObject;
        }

        @Override
        public CharSequence getCharContent(boolean ignoreEncodingErrors) throws IOException {
            try (var in = fileObject.openInputStream()) {
                return decode(in.readAllBytes());
            }
        }
    }
}
