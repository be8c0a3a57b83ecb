package programs.files;

import java.io.Closeable;
import java.io.File;
import java.io.IOException;
import java.util.Formatter;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.jar.JarFile;
import java.util.logging.FileHandler;
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
        refused(() -> new ZipFile(new File("x.zip")));
        refused(() -> new JarFile("x.jar", false));
        refused(() -> {
            new FileHandler("x.log", true).close();
            return null;
        });
        refused(() -> new Formatter("x.txt", "UTF-8", Locale.ROOT));
    }

    private static void refused(Callable<Closeable> opener) {
        try {
            opener.call().close();
        } catch (Exception e) {
            System.out.println(e.getMessage());
        }
    }
}
