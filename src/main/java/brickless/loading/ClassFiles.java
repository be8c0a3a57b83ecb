package brickless.loading;

import java.nio.ByteBuffer;
import org.objectweb.asm.ClassReader;

/** Checks class files before they are read, so that a damaged one gives one clear error. */
final class ClassFiles {
    private static final int MAGIC = 0xCAFEBABE;
    private static final int HEADER_BYTES = 8;
    private static final int MAJOR_VERSION_OFFSET = 6;
    private static final int FIRST_MAJOR_VERSION = 45;
    /** Major version minus this is the Java version, from Java 5 on. */
    private static final int VERSION_OFFSET = 44;

    private ClassFiles() {}

    /**
     * A reader of a class file.
     *
     * @throws UnloadableClassError if it is no class file, is damaged, or needs a newer Java than this one
     */
    static ClassReader reader(ClassFile file, String internalName) {
        byte[] bytes = file.bytes();
        if (bytes.length < HEADER_BYTES || ByteBuffer.wrap(bytes).getInt() != MAGIC) {
            throw new UnloadableClassError(internalName, file.origin(), "not a class file", null);
        }
        int major = ByteBuffer.wrap(bytes).getShort(MAJOR_VERSION_OFFSET) & 0xFFFF;
        int newest = Runtime.version().feature() + VERSION_OFFSET;
        if (major < FIRST_MAJOR_VERSION || major > newest) {
            throw new UnloadableClassError(internalName, file.origin(), "compiled for Java " + (major - VERSION_OFFSET)
                    + " but this is Java " + Runtime.version().feature() + "; compile it with --release 8", null);
        }
        try {
            return new ClassReader(bytes);
        } catch (IllegalArgumentException | IndexOutOfBoundsException damaged) {
            throw damaged(file, internalName, damaged);
        }
    }

    /** The error for a class file that cannot be parsed. */
    static UnloadableClassError damaged(ClassFile file, String internalName, RuntimeException cause) {
        return new UnloadableClassError(internalName, file.origin(), "damaged class file", cause);
    }
}
