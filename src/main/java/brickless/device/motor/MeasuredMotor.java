package brickless.device.motor;

import brickless.world.MotorType;

/**
 * What was measured on a motor at 9 V: the rows that its model is derived from.
 *
 * <p>Source: philohome.com measurements of LEGO motors as tabulated in Pybricks' motor data.
 *
 * @param freeRpm speed without load, turns per minute
 * @param freeAmperes current without load
 * @param loadedRpm speed at the loaded point
 * @param loadedNewtonMetres torque at the loaded point
 * @param loadedAmperes current at the loaded point
 * @param timeConstantSeconds time to 63 % of the free speed: assumption (no measured source), see MODELS.md
 */
record MeasuredMotor(double freeRpm, double freeAmperes, double loadedRpm, double loadedNewtonMetres,
        double loadedAmperes,
        double timeConstantSeconds) {
    /** Voltage of all measurements. */
    static final double VOLTS = 9;

    private static final MeasuredMotor LARGE = new MeasuredMotor(175, 0.060, 105, 0.173, 0.69, 0.060);
    private static final MeasuredMotor MEDIUM = new MeasuredMotor(260, 0.100, 165, 0.0664, 0.37, 0.040);
    private static final MeasuredMotor NXT = new MeasuredMotor(170, 0.060, 117, 0.167, 0.55, 0.060);

    static MeasuredMotor of(MotorType type) {
        return switch (type) {
            case LARGE -> LARGE;
            case MEDIUM -> MEDIUM;
            case NXT -> NXT;
        };
    }
}
