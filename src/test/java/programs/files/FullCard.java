package programs.files;

import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;

/** Writes until the card is full, then makes room. */
public class FullCard {
    public static void main(String[] args) throws IOException {
        byte[] megabyte = new byte[1 << 20];
        int written = 0;
        try (FileOutputStream out = new FileOutputStream("big")) {
            while (true) {
                out.write(megabyte);
                written++;
            }
        } catch (IOException e) {
            System.out.println(written + " " + e.getMessage() + " " + new File("/").getFreeSpace());
        }
        System.out.println(new File("big").delete() + " " + (new File("/").getFreeSpace() >> 20));
        new FileOutputStream("small").close();
    }
}
