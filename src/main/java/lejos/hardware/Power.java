package lejos.hardware;

/** The battery. */
public interface Power {
    /** Voltage in millivolts. */
    int getVoltageMilliVolt();

    /** Voltage in volts. */
    float getVoltage();

    /** Current drawn from the battery in amperes. */
    float getBatteryCurrent();

    /** Current drawn by the motors together in amperes. */
    float getMotorCurrent();
}
