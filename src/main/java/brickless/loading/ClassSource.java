package brickless.loading;

import java.io.Closeable;
import java.io.IOException;
import java.net.URL;
import java.util.List;

/** A place that holds class files and resources. */
interface ClassSource extends Closeable {
    /** The file under an internal class name such as {@code lejos/hardware/Sound}, or null. */
    ClassFile find(String internalName);

    /** Every resource under a path such as {@code images/face.png}, in class path order. */
    List<URL> resources(String path) throws IOException;

    @Override
    void close() throws IOException;
}
