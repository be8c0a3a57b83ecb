package programs.files;

import java.io.File;
import java.io.FileFilter;
import java.io.FileOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Date;

/** What {@code java.io.File} tells and does. */
public class FolderTour {
    public static void main(String[] args) throws IOException {
        names();
        files();
        folders();
        removal();
    }

    private static void names() throws IOException {
        File file = new File("sub/../log.txt");
        System.out.println(file + " " + file.getName() + " " + file.getParent() + " " + file.isAbsolute());
        System.out.println(file.getAbsolutePath() + " " + file.getCanonicalPath());
        System.out.println(file.getAbsoluteFile().getParentFile().getParentFile().exists() + " "
                + file.getParentFile().exists());
        System.out.println(new File("a").toURI() + " " + new File(new File("a").toURI())
                .equals(new File("a").getAbsoluteFile()));
        System.out.println(new File("").exists() + " " + new File("").getAbsoluteFile().isDirectory());
        System.out.println(System.getProperty("user.dir") + " " + System.getProperty("user.home"));
    }

    private static void files() throws IOException {
        File file = new File("new.txt");
        System.out.println(file.exists() + " " + file.createNewFile() + " " + file.createNewFile() + " "
                + file.isFile());
        try (FileOutputStream out = new FileOutputStream(file)) {
            out.write(new byte[100]);
        }
        System.out.println(file.length() + " " + file.canRead() + file.canWrite() + file.isHidden());
        System.out.println(new Date(file.lastModified()) + " "
                + (System.currentTimeMillis() - file.lastModified() < 1000));
        System.out.println(file.setLastModified(5000) + " " + file.lastModified());
        File other = new File("/home/root/other.txt");
        System.out.println(file.renameTo(other) + " " + file.exists() + " " + other.length());
        System.out.println(new File("/").getTotalSpace() + " "
                + (new File("/").getTotalSpace() - new File("/").getFreeSpace()));
        File temporary = File.createTempFile("tmp", ".dat");
        temporary.deleteOnExit();
        System.out.println(temporary + " " + File.createTempFile("tmp", null).exists());
    }

    private static void folders() throws IOException {
        System.out.println(new File("deep/er").mkdir() + " " + new File("deep/er").mkdirs() + " "
                + new File("deep/er").mkdirs());
        for (String name : new String[] {"zebra", "Apple", "mango", "10", "9"}) {
            new File("deep/er", name).createNewFile();
        }
        System.out.println(Arrays.toString(new File("deep/er").list()));
        System.out.println(Arrays.toString(new File("deep").listFiles()));
        System.out.println(Arrays.toString(new File("deep/er").list((folder, name) -> name.length() < 3)));
        FileFilter files = File::isDirectory;
        System.out.println(Arrays.toString(new File("deep").listFiles(files)) + " "
                + Arrays.toString(new File("nowhere").list()));
        System.out.println(Arrays.toString(new File("/home").list()) + " " + Arrays.toString(File.listRoots()));
    }

    private static void removal() {
        System.out.println(new File("deep/er").delete() + " " + new File("deep/er/9").delete() + " "
                + new File("deep/er/9").delete());
        for (File file : new File("deep/er").listFiles()) {
            file.delete();
        }
        System.out.println(new File("deep/er").delete() + " " + new File("deep").delete() + " " + new File("deep")
                .exists());
        try {
            new File("gone/x").createNewFile();
        } catch (IOException e) {
            System.out.println(e.getMessage());
        }
    }
}
