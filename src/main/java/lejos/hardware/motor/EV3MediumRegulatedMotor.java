package lejos.hardware.motor;

import lejos.hardware.port.Port;
import lejos.hardware.port.TachoMotorPort;
import lejos.hardware.sensor.EV3SensorConstants;

/** The medium EV3 motor: 260 rpm at 9 V. */
public class EV3MediumRegulatedMotor extends BaseRegulatedMotor {
    private static final int MAX_SPEED_AT_9V = 1560;
    private static final float MOVE_P = 8f;
    private static final float MOVE_I = 0.04f;
    private static final float MOVE_D = 8f;
    private static final float HOLD_P = 8f;
    private static final float HOLD_I = 0.02f;
    private static final float HOLD_D = 0f;
    private static final int OFFSET = 1000;

    /** A motor on an open port, which {@link #close()} leaves open. */
    public EV3MediumRegulatedMotor(TachoMotorPort port) {
        super(port, null, EV3SensorConstants.TYPE_MINITACHO, MOVE_P, MOVE_I, MOVE_D,
                HOLD_P, HOLD_I, HOLD_D, OFFSET, MAX_SPEED_AT_9V);
    }

    /**
     * A motor on a port that is opened now and closed with the motor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if it is not a motor port
     */
    public EV3MediumRegulatedMotor(Port port) {
        super(port, null, EV3SensorConstants.TYPE_NEWTACHO, MOVE_P, MOVE_I, MOVE_D,
                HOLD_P, HOLD_I, HOLD_D, OFFSET, MAX_SPEED_AT_9V);
    }
}
