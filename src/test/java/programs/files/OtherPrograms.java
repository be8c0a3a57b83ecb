package programs.files;

import java.io.File;
import java.io.IOException;
import java.util.zip.ZipFile;

/** Wants things that a simulated brick does not have. */
public class OtherPrograms {
    public static void main(String[] args) throws IOException {
        try {
            Runtime.getRuntime().exec("touch host.txt");
        } catch (IOException e) {
            System.out.println(e.getMessage());
        }
        try {
            new ProcessBuilder("touch", "host.txt").start();
        } catch (IOException e) {
            System.out.println(e.getMessage());
        }
        try {
            new ZipFile(new File("x.zip")).close();
        } catch (UnsupportedOperationException e) {
            System.out.println(e.getMessage());
        }
    }
}
