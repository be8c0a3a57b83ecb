package programs.passing.initialisers;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.nio.charset.StandardCharsets;

/**
 * An object read from a stream is the first use of its class.
 *
 * @expected exited 0
 * @prints initialised
 * @prints 5 3
 */
public class Deserialised {
    static class Written implements Serializable {
        private static final long serialVersionUID = 1L;
        int value = 5;
    }

    /** What comes out when a stream of the other one has its name changed. */
    static class Reading implements Serializable {
        private static final long serialVersionUID = 1L;
        static final int[] TABLE = {1, 2, 3};

        static {
            System.out.println("initialised");
        }

        int value;

        @Override
        public String toString() {
            return value + " " + TABLE[2];
        }
    }

    public static void main(String[] args) throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(new Written());
        }
        String stream = bytes.toString("ISO-8859-1").replace("$Written", "$Reading");
        System.out.println(new ObjectInputStream(new ByteArrayInputStream(stream.getBytes(StandardCharsets.ISO_8859_1)))
                .readObject());
    }
}
