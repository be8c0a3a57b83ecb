package brickless.kernel.hooks;

import java.util.Map;
import java.util.Properties;

/** System properties and environment of rewritten code: those of a brick, never the host's. Per robot. */
public final class PropertyHooks {
    private static final String[] BRICK = {
        "os.name", "Linux", "os.arch", "arm", "os.version", "3.0.0",
        "file.encoding", "UTF-8", "file.separator", "/", "path.separator", ":", "line.separator", "\n",
        "java.version", "1.8.0", "java.specification.version", "1.8", "java.class.version", "52.0",
        "java.vendor", "Brickless", "java.vm.name", "Brickless virtual EV3",
        "java.home", "/home/root/lejos/ejre", "java.class.path", ".", "java.io.tmpdir", "/tmp",
        "user.name", "root", "user.home", "/home/root", "user.dir", "/home/lejos/programs",
        "user.language", "en", "user.timezone", "UTC",
    };
    private static final Map<String, String> ENVIRONMENT = Map.of("HOME", "/home/root");

    private PropertyHooks() {}

    private static Properties brickProperties() {
        Properties brick = new Properties();
        for (int i = 0; i < BRICK.length; i += 2) {
            brick.setProperty(BRICK[i], BRICK[i + 1]);
        }
        return brick;
    }

    /** {@code System.getProperties}. */
    public static Properties getProperties() {
        RobotState robot = Hooks.robot();
        if (robot.properties == null) {
            robot.properties = brickProperties();
        }
        return robot.properties;
    }

    /** {@code System.setProperties}; null restores the brick's. */
    public static void setProperties(Properties replacement) {
        Hooks.robot().properties = replacement;
    }

    /** {@code System.getProperty(key)}. */
    public static String getProperty(String key) {
        return getProperties().getProperty(checked(key));
    }

    /** {@code System.getProperty(key, otherwise)}. */
    public static String getProperty(String key, String otherwise) {
        return getProperties().getProperty(checked(key), otherwise);
    }

    /** {@code System.setProperty}. */
    public static String setProperty(String key, String value) {
        return (String) getProperties().setProperty(checked(key), value);
    }

    /** {@code System.clearProperty}. */
    public static String clearProperty(String key) {
        return (String) getProperties().remove(checked(key));
    }

    /** {@code Integer.getInteger(key)}. */
    public static Integer getInteger(String key) {
        return getInteger(key, null);
    }

    /** {@code Integer.getInteger(key, otherwise)}. */
    public static Integer getInteger(String key, int otherwise) {
        Integer value = getInteger(key, null);
        return value == null ? Integer.valueOf(otherwise) : value;
    }

    /** {@code Integer.getInteger(key, otherwise)}. */
    public static Integer getInteger(String key, Integer otherwise) {
        String value = key == null || key.isEmpty() ? null : getProperties().getProperty(key);
        try {
            return value == null ? otherwise : Integer.decode(value);
        } catch (NumberFormatException notANumber) {
            return otherwise;
        }
    }

    /** {@code Boolean.getBoolean(key)}. */
    public static boolean getBoolean(String key) {
        return key != null && !key.isEmpty() && Boolean.parseBoolean(getProperties().getProperty(key));
    }

    /** {@code System.lineSeparator}. */
    public static String lineSeparator() {
        return "\n";
    }

    /** {@code System.getenv(name)}. */
    public static String getenv(String name) {
        return ENVIRONMENT.get(name);
    }

    /** {@code System.getenv()}. */
    public static Map<String, String> getenv() {
        return ENVIRONMENT;
    }

    private static String checked(String key) {
        if (key.isEmpty()) {
            throw new IllegalArgumentException("key can't be empty");
        }
        return key;
    }
}
