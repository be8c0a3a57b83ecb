package programs.files;

import java.io.FileOutputStream;
import java.io.IOException;

/** Writes files whose names are good on the brick, but not on every host. */
public class OddNames {
    public static void main(String[] args) throws IOException {
        StringBuilder longName = new StringBuilder();
        for (int i = 0; i < 50; i++) {
            longName.append("longer");
        }
        String[] names = {"C:\\log?.txt", "C__log_.txt", "größe.txt", longName.toString(), longName + "2", "Case",
                "case", "/tmp/x", "tab\there"};
        for (int i = 0; i < names.length; i++) {
            try (FileOutputStream out = new FileOutputStream(names[i])) {
                out.write('0' + i);
            }
        }
    }
}
