package brickless.simulation;

import java.util.stream.DoubleStream;

/** What a program's numbers for wheels mean: it does not say in which unit they are, but tyres come in few sizes. */
final class TyreSize {
    /** Tyre of the EV3 core set. */
    static final double DEFAULT_MILLIMETRES = 56;

    /** Tyres of LEGO kits by outer diameter in millimetres. */
    private static final double[] TYRES = {24, 30.4, 43.2, 49.6, 56, 62.4, 68.8, 81.6, 94.2};
    /** Units that programs use: centimetres, millimetres, inches, metres. */
    static final double[] MILLIMETRES_PER_UNIT = {10, 1, 25.4, 1000};
    private static final double LEAST_MILLIMETRES = 15;
    private static final double GREATEST_MILLIMETRES = 150;
    private static final double LEAST_GEAR = 0.05;
    private static final double GREATEST_GEAR = 20;

    private TyreSize() {}

    /** Diameter in millimetres of a diameter in the program's unit; the usual one if no unit makes sense of it. */
    static double millimetres(double diameter) {
        return plausible(diameter * millimetresPerUnit(diameter));
    }

    /** A size that a tyre can have, else the usual one. */
    static double plausible(double size) {
        return size >= LEAST_MILLIMETRES && size <= GREATEST_MILLIMETRES ? size : DEFAULT_MILLIMETRES;
    }

    /** The unit of length in which a diameter comes closest to a tyre that exists; centimetres win ties. */
    static double millimetresPerUnit(double diameter) {
        return closest(diameter, MILLIMETRES_PER_UNIT);
    }

    /** The same, of the units in which the track fits a robot, if there are any: 3.28 and 19 are not inches. */
    static double millimetresPerUnit(double diameter, double track) {
        double[] fitting = DoubleStream.of(MILLIMETRES_PER_UNIT).filter(unit -> DriveFit.isTrack(track * unit))
                .toArray();
        return closest(diameter, fitting.length == 0 ? MILLIMETRES_PER_UNIT : fitting);
    }

    private static double closest(double diameter, double[] units) {
        double best = units[0];
        double error = Double.POSITIVE_INFINITY;
        for (double unit : units) {
            for (double tyre : TYRES) {
                double ratio = Math.abs(StrictMath.log(diameter * unit / tyre));
                if (ratio < error - 1e-9) {
                    error = ratio;
                    best = unit;
                }
            }
        }
        return best;
    }

    /** A gear ratio that can be built, else none. */
    static double gearRatio(double ratio) {
        return ratio >= LEAST_GEAR && ratio <= GREATEST_GEAR ? ratio : 1;
    }
}
