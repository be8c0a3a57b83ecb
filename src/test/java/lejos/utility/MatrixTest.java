package lejos.utility;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import lejos.Agreement;
import org.junit.jupiter.api.Test;

class MatrixTest {
    private static final int CASES = 240;

    @Test
    void agreesWithThePublishedClasses() {
        Agreement.check(MatrixDriver.class, CASES, 1e-9, MatrixDriver::play);
    }

    @Test
    void numbersAreTakenColumnByColumn() {
        Matrix matrix = new Matrix(new double[] {1, 2, 3, 4, 5, 6}, 2);
        assertThat(matrix.getArray()).isDeepEqualTo(new double[][] {{1, 3, 5}, {2, 4, 6}});
        assertThat(matrix.getRowPackedCopy()).containsExactly(1, 3, 5, 2, 4, 6);
        assertThat(matrix.getColumnPackedCopy()).containsExactly(1, 2, 3, 4, 5, 6);
        assertThatThrownBy(() -> new Matrix(new double[5], 2)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Array length must be a multiple of m.");
    }

    @Test
    void rowsAreWrappedOrCopied() {
        double[][] rows = {{1, 2}, {3, 4}};
        assertThat(new Matrix(rows).getArray()).isSameAs(rows);
        assertThat(Matrix.constructWithCopy(rows).getArray()).isNotSameAs(rows).isDeepEqualTo(rows);
        assertThatThrownBy(() -> new Matrix(new double[][] {{1}, {2, 3}})).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("All rows must have the same length.");
    }

    @Test
    void solvesAnEquationWorkedOutByHand() {
        Matrix a = new Matrix(new double[][] {{2, 1}, {1, 3}});
        Matrix x = a.solve(new Matrix(new double[][] {{5}, {10}}));
        assertThat(x.get(0, 0)).isEqualTo(1);
        assertThat(x.get(1, 0)).isEqualTo(3);
        assertThat(new LUDecomposition(a).det()).isEqualTo(5);
    }

    @Test
    void misfitsHaveTheMessagesOfLejos() {
        Matrix a = new Matrix(2, 3, 1);
        assertThatThrownBy(() -> a.plus(new Matrix(3, 2))).hasMessage("Matrix dimensions must agree.");
        assertThatThrownBy(() -> a.times(new Matrix(2, 3))).hasMessage("Matrix inner dimensions must agree.");
        assertThatThrownBy(() -> a.getMatrix(0, 2, 0, 0)).isInstanceOf(ArrayIndexOutOfBoundsException.class)
                .hasMessage("Submatrix indices");
        assertThatThrownBy(() -> a.setMatrix(0, 0, 3, 3, new Matrix(1, 1)))
                .isInstanceOf(ArrayIndexOutOfBoundsException.class);
        assertThatThrownBy(() -> new Matrix(2, 2).inverse()).isInstanceOf(RuntimeException.class)
                .hasMessage("Matrix is singular.");
        assertThatThrownBy(() -> Matrix.identity(2, 2).solve(a.transpose()))
                .hasMessage("Matrix row dimensions must agree.");
        assertThatThrownBy(() -> new LUDecomposition(a.transpose()).det()).hasMessage("Matrix must be square.");
    }

    @Test
    void nonSquareMatricesCannotBeInverted() {
        assertThatThrownBy(() -> new Matrix(2, 3, 1).inverse()).isInstanceOf(RuntimeException.class);
    }

    @Test
    void gainIsUnknownBeforeTheFirstUpdate() {
        Matrix one = Matrix.identity(1, 1);
        assertThat(new KalmanFilter(one, one, one, one, one).getGain()).isNull();
    }
}
