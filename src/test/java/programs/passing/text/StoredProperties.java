package programs.passing.text;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.StringWriter;
import java.util.Properties;

/**
 * A properties file has the program's date, and its lines are in one order.
 *
 * @expected exited 0
 * @prints #what I know
 * @prints #Thu Jan 01 00:00:02 UTC 2015
 * @prints alpha=1
 * @prints escaped true
 * @prints name\=odd=a\\b
 * @prints zeta=2
 * @prints 4 true 5 cm
 * @prints #Thu Jan 01 00:00:02 UTC 2015
 */
public class StoredProperties {
    public static void main(String[] args) throws IOException, InterruptedException {
        Thread.sleep(2000);
        Properties properties = new Properties();
        properties.setProperty("zeta", "2");
        properties.setProperty("name=odd", "a\\b");
        properties.setProperty("alpha", "1");
        properties.setProperty("gr\u00f6\u00dfe", "5 cm");
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        properties.store(file, "what I know");
        for (String line : file.toString("ISO-8859-1").split("\n")) {
            System.out.println(line.startsWith("gr") ? "escaped " + line.equals("gr\\u00F6\\u00DFe=5 cm") : line);
        }
        Properties read = new Properties();
        read.load(new ByteArrayInputStream(file.toByteArray()));
        System.out.println(read.size() + " " + read.equals(properties) + " " + read.getProperty("gr\u00f6\u00dfe"));
        StringWriter bare = new StringWriter();
        new Properties().store(bare, null);
        System.out.print(bare);
    }
}
