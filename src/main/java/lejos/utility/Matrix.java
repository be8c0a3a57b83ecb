package lejos.utility;

import java.io.PrintStream;
import java.io.Serializable;
import java.util.Arrays;
import java.util.function.DoubleBinaryOperator;

/** A matrix of real numbers with the usual arithmetic. Rows and columns count from 0; ranges include both ends. */
public class Matrix implements Cloneable, Serializable {
    private static final long serialVersionUID = 1L;
    private static final String BAD_PART = "Submatrix indices";

    private final double[][] values;
    private final int rows;
    private final int columns;

    /** Zeros. */
    public Matrix(int m, int n) {
        this(new double[m][n], m, n);
    }

    /** The same number everywhere. */
    public Matrix(int m, int n, double s) {
        this(m, n);
        for (double[] row : values) {
            Arrays.fill(row, s);
        }
    }

    /**
     * Wraps an array of rows, which stays shared.
     *
     * @throws IllegalArgumentException if the rows are not equally long
     */
    public Matrix(double[][] a) throws IllegalArgumentException {
        this(a, a.length, a[0].length);
        requireEqualRows(a);
    }

    /** Wraps an array of rows, which stays shared and is not checked. */
    public Matrix(double[][] a, int m, int n) {
        values = a;
        rows = m;
        columns = n;
    }

    /**
     * Takes the numbers column by column.
     *
     * @param m number of rows
     * @throws IllegalArgumentException if the length of the array is no multiple of it
     */
    public Matrix(double[] vals, int m) throws IllegalArgumentException {
        this(m, m == 0 ? 0 : vals.length / m);
        if (m * columns != vals.length) {
            throw new IllegalArgumentException("Array length must be a multiple of m.");
        }
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                values[i][j] = vals[i + j * rows];
            }
        }
    }

    private static void requireEqualRows(double[][] a) {
        for (double[] row : a) {
            if (row.length != a[0].length) {
                throw new IllegalArgumentException("All rows must have the same length.");
            }
        }
    }

    /**
     * A matrix from a copy of an array of rows.
     *
     * @throws IllegalArgumentException if the rows are not equally long
     */
    public static Matrix constructWithCopy(double[][] a) throws IllegalArgumentException {
        return new Matrix(a).copy();
    }

    /** Ones on the diagonal, zeros elsewhere. */
    public static Matrix identity(int m, int n) {
        Matrix result = new Matrix(m, n);
        for (int i = 0; i < Math.min(m, n); i++) {
            result.values[i][i] = 1;
        }
        return result;
    }

    /** Random numbers from 0 up to, not including, 1. */
    public static Matrix random(int m, int n) {
        Matrix result = new Matrix(m, n);
        for (double[] row : result.values) {
            for (int j = 0; j < n; j++) {
                row[j] = Math.random();
            }
        }
        return result;
    }

    /** A copy. */
    public Matrix copy() {
        return new Matrix(getArrayCopy(), rows, columns);
    }

    @Override
    public Object clone() {
        return copy();
    }

    /** The live array of rows. */
    public double[][] getArray() {
        return values;
    }

    /** A copy of the array of rows. */
    public double[][] getArrayCopy() {
        double[][] copy = new double[rows][columns];
        for (int i = 0; i < rows; i++) {
            System.arraycopy(values[i], 0, copy[i], 0, columns);
        }
        return copy;
    }

    /** A copy, column by column. */
    public double[] getColumnPackedCopy() {
        return transpose().getRowPackedCopy();
    }

    /** A copy, row by row. */
    public double[] getRowPackedCopy() {
        double[] packed = new double[rows * columns];
        for (int i = 0; i < rows; i++) {
            System.arraycopy(values[i], 0, packed, i * columns, columns);
        }
        return packed;
    }

    /** Number of rows. */
    public int getRowDimension() {
        return rows;
    }

    /** Number of columns. */
    public int getColumnDimension() {
        return columns;
    }

    /** One number. */
    public double get(int i, int j) {
        return values[i][j];
    }

    /** Sets one number. */
    public void set(int i, int j, double s) {
        values[i][j] = s;
    }

    /**
     * Rows {@code i0} to {@code i1} of columns {@code j0} to {@code j1}.
     *
     * @throws ArrayIndexOutOfBoundsException if they are not all there
     */
    public Matrix getMatrix(int i0, int i1, int j0, int j1) throws ArrayIndexOutOfBoundsException {
        return getMatrix(range(i0, i1), range(j0, j1));
    }

    /**
     * The rows {@code r} of the columns {@code c}.
     *
     * @throws ArrayIndexOutOfBoundsException if they are not all there
     */
    public Matrix getMatrix(int[] r, int[] c) throws ArrayIndexOutOfBoundsException {
        Matrix part = new Matrix(r.length, c.length);
        try {
            for (int i = 0; i < r.length; i++) {
                for (int j = 0; j < c.length; j++) {
                    part.values[i][j] = values[r[i]][c[j]];
                }
            }
        } catch (ArrayIndexOutOfBoundsException e) {
            throw badPart(e);
        }
        return part;
    }

    /**
     * Rows {@code i0} to {@code i1} of the columns {@code c}.
     *
     * @throws ArrayIndexOutOfBoundsException if they are not all there
     */
    public Matrix getMatrix(int i0, int i1, int[] c) throws ArrayIndexOutOfBoundsException {
        return getMatrix(range(i0, i1), c);
    }

    /**
     * The rows {@code r} of columns {@code j0} to {@code j1}.
     *
     * @throws ArrayIndexOutOfBoundsException if they are not all there
     */
    public Matrix getMatrix(int[] r, int j0, int j1) throws ArrayIndexOutOfBoundsException {
        return getMatrix(r, range(j0, j1));
    }

    /**
     * Replaces rows {@code i0} to {@code i1} of columns {@code j0} to {@code j1}.
     *
     * @throws ArrayIndexOutOfBoundsException if they are not all there
     */
    public void setMatrix(int i0, int i1, int j0, int j1, Matrix x) throws ArrayIndexOutOfBoundsException {
        setMatrix(range(i0, i1), range(j0, j1), x);
    }

    /**
     * Replaces the rows {@code r} of the columns {@code c}.
     *
     * @throws ArrayIndexOutOfBoundsException if they are not all there
     */
    public void setMatrix(int[] r, int[] c, Matrix x) throws ArrayIndexOutOfBoundsException {
        try {
            for (int i = 0; i < r.length; i++) {
                for (int j = 0; j < c.length; j++) {
                    values[r[i]][c[j]] = x.get(i, j);
                }
            }
        } catch (ArrayIndexOutOfBoundsException e) {
            throw badPart(e);
        }
    }

    /**
     * Replaces the rows {@code r} of columns {@code j0} to {@code j1}.
     *
     * @throws ArrayIndexOutOfBoundsException if they are not all there
     */
    public void setMatrix(int[] r, int j0, int j1, Matrix x) throws ArrayIndexOutOfBoundsException {
        setMatrix(r, range(j0, j1), x);
    }

    /**
     * Replaces rows {@code i0} to {@code i1} of the columns {@code c}.
     *
     * @throws ArrayIndexOutOfBoundsException if they are not all there
     */
    public void setMatrix(int i0, int i1, int[] c, Matrix x) throws ArrayIndexOutOfBoundsException {
        setMatrix(range(i0, i1), c, x);
    }

    private static int[] range(int first, int last) {
        int[] range = new int[last - first + 1];
        for (int i = 0; i < range.length; i++) {
            range[i] = first + i;
        }
        return range;
    }

    private static ArrayIndexOutOfBoundsException badPart(ArrayIndexOutOfBoundsException cause) {
        ArrayIndexOutOfBoundsException e = new ArrayIndexOutOfBoundsException(BAD_PART);
        e.initCause(cause);
        return e;
    }

    /** Rows and columns exchanged. */
    public Matrix transpose() {
        Matrix result = new Matrix(columns, rows);
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                result.values[j][i] = values[i][j];
            }
        }
        return result;
    }

    /** Greatest sum of the amounts in a column. */
    public double norm1() {
        return transpose().normInf();
    }

    /** Greatest sum of the amounts in a row. */
    public double normInf() {
        double greatest = 0;
        for (int i = 0; i < rows; i++) {
            double sum = 0;
            for (int j = 0; j < columns; j++) {
                sum += Math.abs(values[i][j]);
            }
            greatest = Math.max(greatest, sum);
        }
        return greatest;
    }

    /** Square root of the sum of all squares. */
    public double normF() {
        double norm = 0;
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                norm = hypotenuse(norm, values[i][j]);
            }
        }
        return norm;
    }

    /** √(a² + b²) without overflow on the way. */
    private static double hypotenuse(double a, double b) {
        double longer = Math.max(Math.abs(a), Math.abs(b));
        double shorter = Math.min(Math.abs(a), Math.abs(b));
        if (longer == 0) {
            return 0;
        }
        double ratio = shorter / longer;
        return longer * Math.sqrt(1 + ratio * ratio);
    }

    /** All signs exchanged. */
    public Matrix uminus() {
        Matrix result = new Matrix(rows, columns);
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                result.values[i][j] = -values[i][j];
            }
        }
        return result;
    }

    private Matrix combine(Matrix b, Matrix target, DoubleBinaryOperator operator) {
        if (b.rows != rows || b.columns != columns) {
            throw new IllegalArgumentException("Matrix dimensions must agree.");
        }
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                target.values[i][j] = operator.applyAsDouble(values[i][j], b.values[i][j]);
            }
        }
        return target;
    }

    private Matrix sameSize() {
        return new Matrix(rows, columns);
    }

    /** Sum. */
    public Matrix plus(Matrix b) {
        return combine(b, sameSize(), (x, y) -> x + y);
    }

    /** Adds to this matrix and returns it. */
    public Matrix plusEquals(Matrix b) {
        return combine(b, this, (x, y) -> x + y);
    }

    /** Difference. */
    public Matrix minus(Matrix b) {
        return combine(b, sameSize(), (x, y) -> x - y);
    }

    /** Subtracts from this matrix and returns it. */
    public Matrix minusEquals(Matrix b) {
        return combine(b, this, (x, y) -> x - y);
    }

    /** Product element by element. */
    public Matrix arrayTimes(Matrix b) {
        return combine(b, sameSize(), (x, y) -> x * y);
    }

    /** Multiplies this matrix element by element and returns it. */
    public Matrix arrayTimesEquals(Matrix b) {
        return combine(b, this, (x, y) -> x * y);
    }

    /** Element of this by element of {@code b}. */
    public Matrix arrayRightDivide(Matrix b) {
        return combine(b, sameSize(), (x, y) -> x / y);
    }

    /** Divides this matrix element by element and returns it. */
    public Matrix arrayRightDivideEquals(Matrix b) {
        return combine(b, this, (x, y) -> x / y);
    }

    /** Element of {@code b} by element of this. */
    public Matrix arrayLeftDivide(Matrix b) {
        return combine(b, sameSize(), (x, y) -> y / x);
    }

    /** Replaces each element by that of {@code b} divided by it, and returns this matrix. */
    public Matrix arrayLeftDivideEquals(Matrix b) {
        return combine(b, this, (x, y) -> y / x);
    }

    /** Product with a number. */
    public Matrix times(double s) {
        return copy().timesEquals(s);
    }

    /** Multiplies this matrix with a number and returns it. */
    public Matrix timesEquals(double s) {
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                values[i][j] *= s;
            }
        }
        return this;
    }

    /**
     * Matrix product.
     *
     * @throws IllegalArgumentException if this has not as many columns as {@code b} has rows
     */
    public Matrix times(Matrix b) throws IllegalArgumentException {
        if (b.rows != columns) {
            throw new IllegalArgumentException("Matrix inner dimensions must agree.");
        }
        Matrix result = new Matrix(rows, b.columns);
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < b.columns; j++) {
                double sum = 0;
                for (int k = 0; k < columns; k++) {
                    sum += values[i][k] * b.values[k][j];
                }
                result.values[i][j] = sum;
            }
        }
        return result;
    }

    /** Sum of the diagonal. */
    public double trace() {
        double sum = 0;
        for (int i = 0; i < Math.min(rows, columns); i++) {
            sum += values[i][i];
        }
        return sum;
    }

    /**
     * Inverse of a square matrix.
     *
     * @throws RuntimeException if the matrix is singular
     */
    public Matrix inverse() {
        return solve(identity(rows, rows));
    }

    /**
     * The X with {@code this × X = B}, for a square matrix.
     *
     * @throws RuntimeException if the matrix is singular
     * @throws IllegalArgumentException if {@code b} has another number of rows
     */
    public Matrix solve(Matrix b) {
        return new LUDecomposition(this).solve(b);
    }

    /** Prints to {@code System.out}, whatever the argument: a line per row, a blank after each number. */
    public void print(PrintStream out) {
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                System.out.print(values[i][j] + " ");
            }
            System.out.println();
        }
    }
}
