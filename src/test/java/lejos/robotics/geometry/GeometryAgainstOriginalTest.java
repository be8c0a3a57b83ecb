package lejos.robotics.geometry;

import lejos.Agreement;
import org.junit.jupiter.api.Test;

class GeometryAgainstOriginalTest {
    @Test
    void linesAndRectanglesAnswerAlike() {
        Agreement.check(ShapesDriver.class, 5000, 1e-12, ShapesDriver::play);
    }

    @Test
    void pointsAndVectorsAnswerAlike() {
        Agreement.check(PointsDriver.class, 5000, 2e-4, PointsDriver::play);
    }
}
