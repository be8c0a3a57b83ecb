package lejos.internal.io;

import java.util.Properties;

/**
 * The brick's settings. They start out empty and live as long as the program: a virtual brick keeps no settings file.
 */
public class Settings {
    private static final Properties VALUES = new Properties();

    /** Creates an object nobody needs: all methods are static. */
    public Settings() {}

    /** Sets a value; null removes it. */
    public static synchronized void setProperty(String key, String value) {
        if (value == null) {
            VALUES.remove(key);
        } else {
            VALUES.setProperty(key, value);
        }
    }

    /** A value, or the given default. */
    public static synchronized String getProperty(String key, String defaultValue) {
        return VALUES.getProperty(key, defaultValue);
    }
}
