package lejos.robotics;

/** A colour as red, green and blue, and the numbers by which colour sensors name colours. Immutable. */
public class Color {
    /** Red. */
    public static final int RED = 0;
    /** Green. */
    public static final int GREEN = 1;
    /** Blue. */
    public static final int BLUE = 2;
    /** Yellow. */
    public static final int YELLOW = 3;
    /** Magenta. */
    public static final int MAGENTA = 4;
    /** Orange. */
    public static final int ORANGE = 5;
    /** White. */
    public static final int WHITE = 6;
    /** Black. */
    public static final int BLACK = 7;
    /** Pink. */
    public static final int PINK = 8;
    /** Grey. */
    public static final int GRAY = 9;
    /** Light grey. */
    public static final int LIGHT_GRAY = 10;
    /** Dark grey. */
    public static final int DARK_GRAY = 11;
    /** Cyan. */
    public static final int CYAN = 12;
    /** Brown. */
    public static final int BROWN = 13;
    /** No colour, or none that has a number. */
    public static final int NONE = -1;

    private final int red;
    private final int green;
    private final int blue;
    private final int color;

    /**
     * A colour without a number of its own: {@link #getColor()} says 0, as leJOS does. Components normally 0 to 255,
     * not checked.
     */
    public Color(int red, int green, int blue) {
        this(red, green, blue, RED);
    }

    /** A colour with its number; components normally 0 to 255; nothing is checked. */
    public Color(int red, int green, int blue, int color) {
        this.red = red;
        this.green = green;
        this.blue = blue;
        this.color = color;
    }

    /** Red component, normally 0 to 255. */
    public int getRed() {
        return red;
    }

    /** Green component, normally 0 to 255. */
    public int getGreen() {
        return green;
    }

    /** Blue component, normally 0 to 255. */
    public int getBlue() {
        return blue;
    }

    /** Number of the colour, one of the constants above. */
    public int getColor() {
        return color;
    }
}
