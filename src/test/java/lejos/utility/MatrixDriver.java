package lejos.utility;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;

/** Calculates with matrices that the index decides, with whatever classes it is linked with. */
final class MatrixDriver {
    private final Map<String, Double> seen = new LinkedHashMap<>();
    private final Random random;

    private MatrixDriver(int index) {
        random = new Random(index);
    }

    static Map<String, Double> play(int index) {
        MatrixDriver driver = new MatrixDriver(index);
        driver.arithmetic(1 + index % 4, 1 + index / 4 % 3);
        driver.decomposition(1 + index % 5, index % 11 == 0);
        driver.filter(1 + index % 3, 1 + index / 3 % 2);
        return driver.seen;
    }

    private Matrix matrix(int rows, int columns) {
        double[] values = new double[rows * columns];
        for (int i = 0; i < values.length; i++) {
            values[i] = random.nextInt(41) / 4.0 - 5;
        }
        return new Matrix(values, rows);
    }

    private void arithmetic(int rows, int columns) {
        Matrix a = matrix(rows, columns);
        Matrix b = matrix(rows, columns);
        note("plus", a.plus(b));
        note("minus", a.minus(b));
        note("arrayTimes", a.arrayTimes(b));
        note("right", a.arrayRightDivide(b));
        note("left", a.arrayLeftDivide(b));
        note("times", a.times(b.transpose()));
        note("scaled", a.times(-1.5).uminus());
        note("norm1", a.norm1());
        note("normInf", a.normInf());
        note("normF", a.normF());
        note("trace", a.trace());
        note("part", a.getMatrix(0, rows - 1, new int[] {columns - 1, 0}));
        note("packed", new Matrix(a.getColumnPackedCopy(), rows).minus(a));
        Matrix c = a.copy();
        c.setMatrix(new int[] {rows - 1}, 0, columns - 1, b);
        note("set", c);
        note("equals", a.plusEquals(b).minusEquals(c).arrayTimesEquals(b).timesEquals(2));
    }

    private void decomposition(int size, boolean singular) {
        Matrix a = matrix(size, size);
        if (singular && size > 1) {
            a.setMatrix(0, 0, 0, size - 1, a.getMatrix(1, 1, 0, size - 1));
        }
        LUDecomposition lu = new LUDecomposition(a);
        note("L", lu.getL());
        note("U", lu.getU());
        note("det", lu.det());
        note("nonsingular", lu.isNonsingular() ? 1 : 0);
        for (int i = 0; i < size; i++) {
            note("pivot" + i, lu.getPivot()[i] + lu.getDoublePivot()[i]);
        }
        try {
            note("solution", a.solve(matrix(size, 2)));
            note("inverse", a.inverse());
        } catch (RuntimeException e) {
            note(e.getClass().getName() + e.getMessage(), 1);
        }
    }

    private void filter(int states, int measured) {
        Matrix noise = Matrix.identity(measured, measured).times(0.5);
        KalmanFilter filter = new KalmanFilter(matrix(states, states).times(0.1), matrix(states, 1),
                matrix(measured, states),
                noise, Matrix.identity(states, states).times(0.2));
        filter.setState(new Matrix(states, 1, 0.5), Matrix.identity(states, states));
        for (int i = 0; i < 3; i++) {
            filter.update(matrix(1, 1), matrix(measured, 1));
            note("mean" + i, filter.getMean());
            note("covariance" + i, filter.getCovariance());
            note("predicted" + i, filter.getPredictedMean());
            note("predictedCovariance" + i, filter.getPredictedCovariance());
            note("gain" + i, filter.getGain());
        }
    }

    private void note(String label, Matrix matrix) {
        note(label + " rows", matrix.getRowDimension());
        for (int i = 0; i < matrix.getRowDimension(); i++) {
            for (int j = 0; j < matrix.getColumnDimension(); j++) {
                note(label + " " + i + "," + j, matrix.get(i, j));
            }
        }
    }

    private void note(String label, double value) {
        seen.put(label, value);
    }
}
