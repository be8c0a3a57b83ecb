package brickless.loading;

import java.io.IOException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Looks into class files, without loading them, for main methods. */
public final class MainClasses {
    private MainClasses() {}

    /** Binary names of the classes with a {@code public static void main(String[])} in a directory or jar, sorted. */
    public static List<String> of(Path entry) throws IOException {
        if (Files.isDirectory(entry)) {
            return below(entry);
        }
        try (FileSystem jar = FileSystems.newFileSystem(entry)) {
            return below(jar.getPath("/"));
        }
    }

    /** Whether a directory or jar holds a class. */
    public static boolean contains(Path entry, String className) throws IOException {
        String file = className.replace('.', '/') + ".class";
        if (Files.isDirectory(entry)) {
            return Files.exists(entry.resolve(file));
        }
        try (FileSystem jar = FileSystems.newFileSystem(entry)) {
            return Files.exists(jar.getPath("/" + file));
        }
    }

    /** Binary name of the class in a class file, empty if it is none. */
    public static Optional<String> nameOf(byte[] classFile) {
        return isClassFile(classFile) ? Optional.of(new ClassReader(classFile).getClassName().replace('/', '.'))
                : Optional.empty();
    }

    private static List<String> below(Path root) throws IOException {
        List<String> names = new ArrayList<>();
        try (Stream<Path> files = Files.walk(root)) {
            for (Path file : files.filter(f -> f.toString().endsWith(".class")
                    && !f.toString().contains("META-INF/versions")).toList()) {
                byte[] bytes = Files.readAllBytes(file);
                if (isClassFile(bytes) && hasMain(bytes)) {
                    names.add(new ClassReader(bytes).getClassName().replace('/', '.'));
                }
            }
        }
        Collections.sort(names);
        return names;
    }

    private static boolean isClassFile(byte[] bytes) {
        return bytes.length > 10 && (bytes[0] & 0xff) == 0xca && (bytes[1] & 0xff) == 0xfe && (bytes[2] & 0xff) == 0xba
                && (bytes[3] & 0xff) == 0xbe;
    }

    /** Whether a class file has a {@code public static void main(String[])}. */
    public static boolean hasMain(byte[] classFile) {
        boolean[] found = new boolean[1];
        new ClassReader(classFile).accept(new ClassVisitor(Opcodes.ASM9) {
            @Override
            public MethodVisitor visitMethod(int access, String name, String descriptor, String signature,
                    String[] exceptions) {
                int needed = Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC;
                found[0] |= name.equals("main") && descriptor.equals("([Ljava/lang/String;)V")
                        && (access & needed) == needed;
                return null;
            }
        }, ClassReader.SKIP_CODE | ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
        return found[0];
    }
}
