package lejos.hardware.motor;

import lejos.hardware.port.Port;
import lejos.hardware.port.TachoMotorPort;
import lejos.hardware.sensor.EV3SensorConstants;

/** A Power Functions M motor with a Mindsensors GlideWheel-M encoder: 405 rpm at 9 V. */
public class MindsensorsGlideWheelMRegulatedMotor extends BaseRegulatedMotor {
    private static final int MAX_SPEED_AT_9V = 2430;
    private static final float MOVE_P = 3.5f;
    private static final float MOVE_I = 0.01f;
    private static final float MOVE_D = 3f;
    private static final float HOLD_P = 2.5f;
    private static final float HOLD_I = 0f;
    private static final float HOLD_D = 0f;
    private static final int OFFSET = 0;

    /** A motor on an open port, which {@link #close()} leaves open. */
    public MindsensorsGlideWheelMRegulatedMotor(TachoMotorPort port) {
        super(port, null, EV3SensorConstants.TYPE_MINITACHO, MOVE_P, MOVE_I, MOVE_D,
                HOLD_P, HOLD_I, HOLD_D, OFFSET, MAX_SPEED_AT_9V);
    }

    /**
     * A motor on a port that is opened now and closed with the motor.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if it is not a motor port
     */
    public MindsensorsGlideWheelMRegulatedMotor(Port port) {
        super(port, null, EV3SensorConstants.TYPE_NEWTACHO, MOVE_P, MOVE_I, MOVE_D,
                HOLD_P, HOLD_I, HOLD_D, OFFSET, MAX_SPEED_AT_9V);
    }
}
