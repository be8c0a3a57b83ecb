package lejos.hardware;

/** The battery of the default brick. */
public class Battery {
    private static final Power POWER = BrickFinder.getDefault().getPower();

    /** Creates an object nobody needs: all methods are static. */
    public Battery() {}

    /** Voltage in millivolts. */
    public static int getVoltageMilliVolt() {
        return POWER.getVoltageMilliVolt();
    }

    /** Voltage in volts. */
    public static float getVoltage() {
        return POWER.getVoltage();
    }

    /** Current drawn from the battery in amperes. */
    public static float getBatteryCurrent() {
        return POWER.getBatteryCurrent();
    }

    /** Current drawn by the motors together in amperes. */
    public static float getMotorCurrent() {
        return POWER.getMotorCurrent();
    }
}
