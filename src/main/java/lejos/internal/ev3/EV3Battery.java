package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import lejos.hardware.Power;

/** The battery of the local brick. */
public class EV3Battery implements Power {
    private static final int MILLIVOLTS_PER_VOLT = 1000;

    /** The battery of the local brick. */
    public EV3Battery() {}

    @Override
    public int getVoltageMilliVolt() {
        return (int) (getVoltage() * MILLIVOLTS_PER_VOLT);
    }

    @Override
    public float getVoltage() {
        return BrickAccess.brick().power().voltageVolts();
    }

    @Override
    public float getBatteryCurrent() {
        return BrickAccess.brick().power().batteryCurrentAmperes();
    }

    @Override
    public float getMotorCurrent() {
        return BrickAccess.brick().power().motorCurrentAmperes();
    }
}
