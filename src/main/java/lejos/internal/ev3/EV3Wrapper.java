package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import lejos.hardware.lcd.LCDOutputStream;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;

/**
 * Starts a program the way the brick's menu does: prepares the layers of the screen, duplicates {@code System.out} and
 * {@code System.err} to the screen, shows exceptions that nobody caught, and calls {@code main}.
 */
public class EV3Wrapper implements Thread.UncaughtExceptionHandler {
    private static final String PRINTED_LAYER = "STDOUT";
    private static final String SYSTEM_LAYER = "SYSTEM";

    /** A handler of uncaught exceptions. */
    public EV3Wrapper() {}

    /**
     * Starts the program whose main class is named first; it gets no arguments.
     *
     * @throws Throwable what the program's {@code main} throws, or an exception that tells why it cannot be started
     */
    public static void main(String[] args) throws Throwable {
        run(Class.forName(args[0]), new String[0]);
    }

    /**
     * Starts a program on the calling thread; returns when its {@code main} returns.
     *
     * @param mainClass class with {@code static void main(String[])}; neither needs to be public
     * @throws Throwable what the program's {@code main} throws, or an exception that tells why it cannot be started
     */
    public static void run(Class<?> mainClass, String[] args) throws Throwable {
        prepare();
        Method main = mainClass.getDeclaredMethod("main", String[].class);
        main.setAccessible(true);
        try {
            main.invoke(null, (Object) args);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    /** Prepares the ports, the layers of the screen, the program's console and the exception screen. */
    public static void prepare() {
        // Interfaces are initialised inside the JVM, where a thread cannot be switched away: done while there is only
        // one.
        MotorPort.A.getName();
        SensorPort.S1.getName();
        EV3LCDManager layers = EV3LCDManager.getLocalLCDManager();
        layers.getLayer(EV3LCD.PROGRAM_LAYER);
        LCDOutputStream printed = new LCDOutputStream(new PrintedText(PRINTED_LAYER));
        layers.newLayer(ExceptionScreen.LAYER);
        layers.newLayer(SYSTEM_LAYER);
        System.setOut(new PrintStream(new PrintedBytes(BrickAccess.brick().log(), printed, false), true));
        System.setErr(new PrintStream(new PrintedBytes(BrickAccess.brick().log(), printed, true), true));
        Thread.setDefaultUncaughtExceptionHandler(new EV3Wrapper());
    }

    /**
     * Reports the exception, buzzes, and shows it on the screen: until ESCAPE if somebody is there, else for a moment.
     */
    @Override
    public void uncaughtException(Thread t, Throwable e) {
        Throwable shown = e instanceof InvocationTargetException && e.getCause() != null ? e.getCause() : e;
        BrickAccess.brick().log().uncaught(t, shown);
        EV3Audio.getAudio().systemSound(EV3Audio.BUZZ);
        new ExceptionScreen(shown).show();
    }
}
