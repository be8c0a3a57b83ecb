package lejos.internal.io;

/** Typed access to {@link Settings}. */
public class SystemSettings {
    /** Creates an object nobody needs: all methods are static. */
    public SystemSettings() {}

    /** A text setting, or the given default. */
    public static String getStringSetting(String key, String defaultValue) {
        return Settings.getProperty(key, defaultValue);
    }

    /** A number, or the given default if it is missing or no number. */
    public static int getIntSetting(String key, int defaultValue) {
        String value = Settings.getProperty(key, Integer.toString(defaultValue));
        try {
            return Integer.parseInt(value.trim());
        } catch (NumberFormatException notANumber) {
            return defaultValue;
        }
    }
}
