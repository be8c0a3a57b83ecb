package brickless.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import brickless.world.Point2;
import java.util.List;
import org.junit.jupiter.api.Test;

class SupportLoadsTest {
    private static final List<Point2> TRIANGLE = List.of(new Point2(0, -0.06), new Point2(0, 0.06),
            new Point2(-0.09, 0));

    @Test
    void threeSupportsBalanceTheMoments() {
        double[] shares = SupportLoads.shares(TRIANGLE, new Point2(-0.03, 0));
        assertThat(shares[0]).isCloseTo(1.0 / 3, offset(1e-9));
        assertThat(shares[1]).isCloseTo(1.0 / 3, offset(1e-9));
        assertThat(shares[2]).isCloseTo(1.0 / 3, offset(1e-9));
    }

    @Test
    void nearerSupportsCarryMore() {
        double[] shares = SupportLoads.shares(TRIANGLE, new Point2(-0.009, 0.03));
        assertThat(shares[2]).isCloseTo(0.1, offset(1e-9));
        assertThat(shares[1] - shares[0]).isCloseTo(0.5, offset(1e-9));
    }

    @Test
    void twoSupportsShareEvenly() {
        double[] shares = SupportLoads.shares(TRIANGLE.subList(0, 2), new Point2(-0.03, 0));
        assertThat(shares).containsExactly(0.5, 0.5);
    }

    @Test
    void noSupportPullsAndAllTogetherCarryTheWeight() {
        double[] shares = SupportLoads.shares(TRIANGLE, new Point2(0.05, 0));
        assertThat(shares[2]).isZero();
        assertThat(shares[0] + shares[1]).isCloseTo(1, offset(1e-9));
    }
}
