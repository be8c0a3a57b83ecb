package brickless.device.motor;

import brickless.units.AngularSpeeds;
import brickless.world.MotorType;

/**
 * Constants of a geared DC motor at its output shaft.
 *
 * <p>Derivation from {@link MeasuredMotor}, with index 0 for the free and 1 for the loaded point, V = 9 V:
 * <pre>
 * torque constant   Kt = M1 / (I1 − I0)                 friction takes the free current
 * friction          Mf = Kt · I0
 * V = Ke·ω0 + R·I0 = Ke·ω1 + R·I1, hence
 * resistance        R  = Ke · (ω0 − ω1) / (I1 − I0)
 * back-EMF constant Ke = V / (ω0 + I0 · (ω0 − ω1) / (I1 − I0))
 * inertia           J  = τ · Kt · Ke / R                with the assumed time constant τ
 * </pre>
 * For the large motor: Kt = 0.173 / 0.63 = 0.2746 N·m/A, Mf = 16.5 mN·m, Ke = 0.4731 V·s/rad, R = 5.50 Ω, stall current
 * 9 / 5.50 = 1.64 A, stall
 * torque 0.2746 · 1.64 − 0.0165 = 0.433 N·m, J = 1.42e-3 kg·m². Kt is below Ke because the gears lose torque.
 *
 * @param torqueConstant N·m per ampere at the output shaft, gear losses included
 * @param backEmfConstant volts per radian per second
 * @param resistanceOhms of the winding
 * @param frictionNewtonMetres Coulomb friction while turning
 * @param inertia rotor and gears at the output shaft, kg·m²
 */
record MotorConstants(double torqueConstant, double backEmfConstant, double resistanceOhms,
        double frictionNewtonMetres, double inertia) {
    /**
     * Breakaway friction over friction while turning: assumption; gives the dead band of 5 to 10 % duty that real
     * motors show.
     */
    static final double STICTION = 1.5;

    /** Constants of a motor type. */
    static MotorConstants of(MotorType type) {
        MeasuredMotor measured = MeasuredMotor.of(type);
        double free = AngularSpeeds.radiansPerSecondFromRpm(measured.freeRpm());
        double drop = free - AngularSpeeds.radiansPerSecondFromRpm(measured.loadedRpm());
        double rise = measured.loadedAmperes() - measured.freeAmperes();
        double kt = measured.loadedNewtonMetres() / rise;
        double ke = MeasuredMotor.VOLTS / (free + measured.freeAmperes() * drop / rise);
        double resistance = ke * drop / rise;
        return new MotorConstants(kt, ke, resistance, kt * measured.freeAmperes(),
                measured.timeConstantSeconds() * kt * ke / resistance);
    }

    /** Current at a terminal voltage and a speed, amperes. */
    double amperes(double volts, double radiansPerSecond) {
        return (volts - backEmfConstant * radiansPerSecond) / resistanceOhms;
    }
}
