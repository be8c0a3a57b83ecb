package lejos.internal.ev3;

import lejos.hardware.port.AnalogPort;
import lejos.utility.Delay;

/** An input port opened for its analogue pins. */
public class EV3AnalogPort extends EV3SensorIOPort implements AnalogPort {
    /** An NXT colour sensor hands over its calibration when all its lamps are switched on: milliseconds. */
    private static final int CALIBRATION_MILLIS = 1000;

    /** A port that is not open yet. */
    public EV3AnalogPort() {}

    @Override
    public float getPin1() {
        return (float) socket().analog().pin1Volts();
    }

    @Override
    public float getPin6() {
        return (float) socket().analog().pin6Volts();
    }

    @Override
    public void getFloats(float[] vals, int offset, int length) {
        float[] volts = socket().analog().colourVolts();
        for (int i = 0; i < length; i++) {
            vals[offset + i] = i < volts.length ? volts[i] : 0;
        }
    }

    /** {@inheritDoc} Blocks until one fresh sample has been taken; {@link #TYPE_COLORFULL} takes a second longer. */
    @Override
    public boolean setType(int type) {
        if (!analogue(type) || !socket().analog().setType(type)) {
            return false;
        }
        if (type == TYPE_COLORFULL) {
            Delay.msDelay(CALIBRATION_MILLIS);
        }
        return true;
    }

    private static boolean analogue(int type) {
        return type >= MIN_TYPE && type <= TYPE_COLORNONE && type != TYPE_HISPEED;
    }
}
