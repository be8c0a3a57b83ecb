package lejos.utility;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Splits the rows of a matrix, reordered, into a lower triangular matrix with ones on the diagonal times an upper
 * triangular one, taking the greatest remaining number of each column as pivot.
 */
public class LUDecomposition implements Serializable {
    private static final long serialVersionUID = 1L;

    /** Both factors in one: the upper one with the diagonal, the lower one below it. */
    private final double[][] lu;
    private final int rows;
    private final int columns;
    private final int[] order;
    private boolean evenExchanges = true;

    /** Decomposes a matrix with at least as many rows as columns. */
    public LUDecomposition(Matrix a) {
        lu = a.getArrayCopy();
        rows = a.getRowDimension();
        columns = a.getColumnDimension();
        order = new int[rows];
        for (int i = 0; i < rows; i++) {
            order[i] = i;
        }
        for (int j = 0; j < columns; j++) {
            reduceColumn(j);
            exchange(j, pivotRow(j));
            divideBelow(j);
        }
    }

    /** Subtracts what the columns to the left already explain. */
    private void reduceColumn(int j) {
        for (int i = 0; i < rows; i++) {
            double explained = 0;
            for (int k = 0; k < Math.min(i, j); k++) {
                explained += lu[i][k] * lu[k][j];
            }
            lu[i][j] -= explained;
        }
    }

    private int pivotRow(int j) {
        int pivot = j;
        for (int i = j + 1; i < rows; i++) {
            if (Math.abs(lu[i][j]) > Math.abs(lu[pivot][j])) {
                pivot = i;
            }
        }
        return pivot;
    }

    private void exchange(int j, int pivot) {
        if (pivot != j) {
            double[] row = lu[pivot];
            lu[pivot] = lu[j];
            lu[j] = row;
            int number = order[pivot];
            order[pivot] = order[j];
            order[j] = number;
            evenExchanges = !evenExchanges;
        }
    }

    private void divideBelow(int j) {
        if (j < rows && lu[j][j] != 0) {
            for (int i = j + 1; i < rows; i++) {
                lu[i][j] /= lu[j][j];
            }
        }
    }

    /** Whether no number on the upper factor's diagonal is exactly 0. */
    public boolean isNonsingular() {
        for (int j = 0; j < columns; j++) {
            if (lu[j][j] == 0) {
                return false;
            }
        }
        return true;
    }

    /** The lower factor. */
    public Matrix getL() {
        Matrix lower = new Matrix(rows, columns);
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < Math.min(i, columns); j++) {
                lower.set(i, j, lu[i][j]);
            }
            if (i < columns) {
                lower.set(i, i, 1);
            }
        }
        return lower;
    }

    /** The upper factor. */
    public Matrix getU() {
        Matrix upper = new Matrix(columns, columns);
        for (int i = 0; i < columns; i++) {
            for (int j = i; j < columns; j++) {
                upper.set(i, j, lu[i][j]);
            }
        }
        return upper;
    }

    /** For each row of the factors the number of the original row. */
    public int[] getPivot() {
        return order.clone();
    }

    /** The same as {@link #getPivot()} in floating point. */
    public double[] getDoublePivot() {
        return Arrays.stream(order).asDoubleStream().toArray();
    }

    /**
     * Determinant.
     *
     * @throws IllegalArgumentException if the matrix is not square
     */
    public double det() {
        if (rows != columns) {
            throw new IllegalArgumentException("Matrix must be square.");
        }
        double product = evenExchanges ? 1 : -1;
        for (int j = 0; j < columns; j++) {
            product *= lu[j][j];
        }
        return product;
    }

    /**
     * The X with {@code A × X = B}.
     *
     * @throws IllegalArgumentException if {@code b} has another number of rows
     * @throws RuntimeException if the matrix is singular
     */
    public Matrix solve(Matrix b) {
        if (b.getRowDimension() != rows) {
            throw new IllegalArgumentException("Matrix row dimensions must agree.");
        }
        if (!isNonsingular()) {
            throw new RuntimeException("Matrix is singular.");
        }
        Matrix x = new Matrix(columns, b.getColumnDimension());
        for (int j = 0; j < b.getColumnDimension(); j++) {
            solveColumn(b, x, j);
        }
        return x;
    }

    private void solveColumn(Matrix b, Matrix x, int column) {
        double[] rest = new double[rows];
        for (int i = 0; i < rows; i++) {
            rest[i] = b.get(order[i], column);
        }
        for (int k = 0; k < columns; k++) {
            for (int i = k + 1; i < columns; i++) {
                rest[i] -= rest[k] * lu[i][k];
            }
        }
        for (int k = columns - 1; k >= 0; k--) {
            rest[k] /= lu[k][k];
            for (int i = 0; i < k; i++) {
                rest[i] -= rest[k] * lu[i][k];
            }
            x.set(k, column, rest[k]);
        }
    }
}
