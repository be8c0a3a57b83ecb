package brickless.device.sensor;

import brickless.world.World;
import java.util.Arrays;

/**
 * Remembers the colours of a floor in cells of half a millimetre, filled in where somebody looks: programs look at the
 * same lines again and again, and drawings may have thousands of edges. A cell has the colour of its centre.
 */
final class FloorTiles implements FloorColour {
    private static final double CELL = 0.0005;
    private static final int TILE = 64;
    private static final int UNKNOWN = Integer.MIN_VALUE;

    private final FloorColour floor;
    private final double left;
    private final double top;
    private final int[][][] tiles;

    FloorTiles(FloorColour floor, World world) {
        this.floor = floor;
        left = world.minX();
        top = world.minY();
        tiles = new int[tiles(world.height())][tiles(world.width())][];
    }

    private static int tiles(double metres) {
        return (int) Math.ceil(metres / CELL / TILE);
    }

    @Override public int at(double x, double y) {
        int column = (int) Math.floor((x - left) / CELL);
        int row = (int) Math.floor((y - top) / CELL);
        if (column < 0 || row < 0 || row / TILE >= tiles.length || column / TILE >= tiles[0].length) {
            return floor.at(x, y);
        }
        int[] cells = tile(row / TILE, column / TILE);
        int cell = row % TILE * TILE + column % TILE;
        if (cells[cell] == UNKNOWN) {
            cells[cell] = floor.at(left + (column + 0.5) * CELL, top + (row + 0.5) * CELL);
        }
        return cells[cell];
    }

    private int[] tile(int row, int column) {
        if (tiles[row][column] == null) {
            tiles[row][column] = new int[TILE * TILE];
            Arrays.fill(tiles[row][column], UNKNOWN);
        }
        return tiles[row][column];
    }
}
