package brickless.device.motor;

import brickless.physics.Shaft;
import brickless.world.MotorType;

/**
 * A motor on a shaft, driven by a bridge: pulse width from −100 to 100 % with the pauses short-circuited, or open
 * terminals.
 */
final class DcMotor {
    /** Slower than this counts as standing still, radians per second. */
    private static final double STANDING = 1e-6;

    private final MotorConstants constants;
    private final Shaft shaft;
    private double duty;
    private boolean open = true;
    private double amperes;

    DcMotor(MotorType type, Shaft shaft) {
        this.constants = MotorConstants.of(type);
        this.shaft = shaft;
        shaft.setInertia(constants.inertia());
    }

    /** Sets the bridge: a duty from −1 to 1 (0 brakes). */
    void drive(double newDuty) {
        duty = newDuty;
        open = false;
    }

    /** Opens the terminals. */
    void coast() {
        duty = 0;
        open = true;
    }

    /** Puts the torque for the coming step on the shaft. */
    void beforeStep(double volts) {
        double speed = shaft.speedRadiansPerSecond();
        double friction = constants.frictionNewtonMetres() * (Math.abs(speed) < STANDING ? MotorConstants.STICTION : 1);
        if (open) {
            amperes = 0;
            shaft.drive(0, 0, friction);
            return;
        }
        amperes = constants.amperes(duty * volts, speed);
        double gain = constants.torqueConstant() / constants.resistanceOhms();
        shaft.drive(gain * duty * volts, gain * constants.backEmfConstant(), friction);
    }

    /** Duty of the bridge, −1 to 1. */
    double duty() {
        return duty;
    }

    /** Current in the winding at the start of the step, amperes, signed. */
    double amperes() {
        return amperes;
    }

    /**
     * Current taken from the battery, amperes: the winding's during the on-time only; negative when the motor
     * generates.
     */
    double batteryAmperes() {
        return duty * amperes;
    }
}
