package brickless.loading;

import org.objectweb.asm.Attribute;
import org.objectweb.asm.ByteVector;
import org.objectweb.asm.ClassWriter;

/**
 * Marks a static field in a rewritten class file that was final: nobody but its class's initialiser sets it, though the
 * JVM no longer knows.
 */
final class OnceFinal extends Attribute {
    private static final String NAME = "brickless.OnceFinal";

    OnceFinal() {
        super(NAME);
    }

    /** Whether it is the mark. */
    static boolean is(Attribute attribute) {
        return attribute.type.equals(NAME);
    }

    @Override
    protected ByteVector write(ClassWriter writer, byte[] code, int codeLength, int maxStack, int maxLocals) {
        return new ByteVector();
    }
}
