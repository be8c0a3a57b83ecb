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

    /** Metres to millimetres. */
    public static double millimetresFromMetres(double metres) {
        return metres * 1000;
    }
}
