package brickless.kernel.hooks;

import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectStreamClass;

/**
 * What {@code new ObjectInputStream} becomes in a rewritten program: objects appear without a constructor, so their
 * classes are initialised when the stream names them. Per robot.
 */
public class ProgramObjectInputStream extends ObjectInputStream {
    /** Like {@link ObjectInputStream#ObjectInputStream(InputStream)}. */
    public ProgramObjectInputStream(InputStream in) throws IOException {
        super(in);
    }

    /** Like {@link ObjectInputStream#ObjectInputStream()}. */
    protected ProgramObjectInputStream() throws IOException {
    }

    @Override
    protected Class<?> resolveClass(ObjectStreamClass description) throws IOException, ClassNotFoundException {
        Class<?> type = super.resolveClass(description);
        ClassInitialization.initializeForReflection(type);
        return type;
    }
}
