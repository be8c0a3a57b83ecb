package programs.passing.text;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.text.DecimalFormat;
import java.util.Locale;
import java.util.Scanner;

/**
 * Language, encoding and line ends are the brick's, whatever the host's are.
 *
 * @expected exited 0
 * @prints en UTF-8 1,234.5 3.14 1.50
 * @prints TITLE title 3
 * @prints 2.5 ä
 * @prints true true
 */
public class LocaleAndEncoding {
    public static void main(String[] args) throws IOException {
        System.out.println(Locale.getDefault() + " " + Charset.defaultCharset() + " " + new DecimalFormat("#,###.0")
                .format(1234.5)
                + String.format(" %.2f", 3.14159) + " " + "%.2f".formatted(1.5));
        System.out.println("title".toUpperCase() + " " + "TITLE".toLowerCase() + " " + "aä".getBytes().length);
        Scanner scanner = new Scanner(new ByteArrayInputStream("2.5 ä".getBytes()));
        System.out.println(scanner.nextDouble() + " " + scanner.next());
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        OutputStreamWriter writer = new OutputStreamWriter(bytes);
        writer.write("ä");
        writer.close();
        int read = new InputStreamReader(new ByteArrayInputStream(bytes.toByteArray())).read();
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        PrintWriter printer = new PrintWriter(text);
        printer.printf("ä%n");
        printer.flush();
        System.out.println((read == 'ä') + " " + text.toString().equals("ä" + System.lineSeparator()));
    }
}
