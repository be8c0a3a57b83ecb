package lejos.robotics.mapping;

/** A map of square cells, each occupied to some degree. */
public class OccupancyGridMap {
    private final byte[][] cells;
    private final int width;
    private final int height;
    private final double freeThreshold;
    private final double occupiedThreshold;
    private final double resolution;

    /**
     * A map of empty cells.
     *
     * @param width cells along x
     * @param height cells along y
     * @param freeThreshold up to this value a cell is free
     * @param occupiedThreshold from this value on a cell is occupied
     * @param resolution side of a cell
     */
    public OccupancyGridMap(int width, int height, double freeThreshold, double occupiedThreshold, double resolution) {
        this.cells = new byte[width][height];
        this.width = width;
        this.height = height;
        this.freeThreshold = freeThreshold;
        this.occupiedThreshold = occupiedThreshold;
        this.resolution = resolution;
    }

    /** Cells along x. */
    public int getWidth() {
        return width;
    }

    /** Cells along y. */
    public int getHeight() {
        return height;
    }

    /** Side of a cell. */
    public double getResolution() {
        return resolution;
    }

    /** Up to this value a cell is free. */
    public double getFreeThreshold() {
        return freeThreshold;
    }

    /** From this value on a cell is occupied. */
    public double getOccupiedThreshold() {
        return occupiedThreshold;
    }

    /** Sets how occupied a cell is; only the low eight bits are kept. */
    public void setOccupied(int x, int y, int occupied) {
        cells[x][y] = (byte) occupied;
    }

    /** How occupied a cell is, −128 to 127. */
    public int getOccupied(int x, int y) {
        return cells[x][y];
    }

    /** Whether a cell is occupied. */
    public boolean isOccupied(int x, int y) {
        return cells[x][y] >= occupiedThreshold;
    }

    /** Whether a cell is free. */
    public boolean isFree(int x, int y) {
        return cells[x][y] <= freeThreshold;
    }
}
