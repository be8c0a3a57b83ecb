package brickless.units;

/** Lengths: the project computes in metres; drawings use millimetres, programs also centimetres and inches. */
public final class Lengths {
    /** Metres in one inch, exactly (international inch). */
    public static final double METRES_PER_INCH = 0.0254;

    private Lengths() {}

    /** Millimetres to metres. */
    public static double metresFromMillimetres(double millimetres) {
        return millimetres / 1000;
    }

    /** Centimetres to metres. */
    public static double metresFromCentimetres(double centimetres) {
        return centimetres / 100;
    }

    /** Inches to metres. */
    public static double metresFromInches(double inches) {
        return inches * METRES_PER_INCH;
    }

    /** Metres to millimetres. */
    public static double millimetresFromMetres(double metres) {
        return metres * 1000;
    }

    /** Metres to centimetres. */
    public static double centimetresFromMetres(double metres) {
        return metres * 100;
    }

    /** Metres to inches. */
    public static double inchesFromMetres(double metres) {
        return metres / METRES_PER_INCH;
    }
}
