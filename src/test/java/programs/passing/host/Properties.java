package programs.passing.host;

/**
 * Properties, environment, memory and processors are the brick's.
 *
 * @expected exited 0
 * @prints Linux arm null / 10
 * @prints 1 processors, plausible memory true
 * @prints set null unset
 * @prints null /home/root
 */
public class Properties {
    public static void main(String[] args) {
        System.out.println(System.getProperty("os.name") + " " + System.getProperty("os.arch") + " "
                + System.getProperty("no.such.thing") + " "
                + System.getProperty("file.separator") + " " + (int) System.lineSeparator().charAt(0));
        Runtime runtime = Runtime.getRuntime();
        System.out.println(runtime.availableProcessors() + " processors, plausible memory "
                + (runtime.freeMemory() < runtime.totalMemory()));
        String before = System.setProperty("mine", "set");
        System.out.println(System.getProperty("mine") + " " + before + " " + System.getProperty("other", "unset"));
        System.out.println(System.getenv("PATH") + " " + System.getenv("HOME"));
    }
}
