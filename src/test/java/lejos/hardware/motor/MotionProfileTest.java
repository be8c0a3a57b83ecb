package lejos.hardware.motor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Plans of the software regulator against times and positions measured on the original, and against the laws of motion.
 */
class MotionProfileTest {
    private static final double ACCELERATION = 6000;

    @ParameterizedTest
    @CsvSource({
        // limit, from, velocity; ramp ends, cruise ends, stands; positions at ramp end and cruise end; cruise velocity
        "360,0,0,60,1000,1060,10.8,349.2,360",
        "-90,0,0,60,249,309,-10.8,-79.2,-360",
        "10,0,0,40,40,80,5.0,5.0,244.9",
        "50,100,360,120,228,288,100,60.8,-360",
        "105,100,360,91,91,122,107.9,107.9,-186.5",
        "300,100,360,0,525,585,100,289.2,360",
        "200,100,-360,120,367,427,100,189.2,360"})
    void plansMatchTheOriginal(double limit, double from, double velocity, int rampEnd, int cruiseEnd, int end,
            double rampPosition, double cruisePosition, double cruise) {
        MotionProfile plan = MotionProfile.to(limit, from, velocity, 360, ACCELERATION);
        assertEquals(end, plan.endMillis(), 1);
        assertEquals(rampPosition, plan.position(rampEnd), 0.4);
        assertEquals(cruisePosition, plan.position(cruiseEnd), 0.4);
        assertEquals(cruise, plan.velocity(rampEnd), 6);
        assertFalse(plan.braking(cruiseEnd - 2));
        assertTrue(plan.braking(cruiseEnd + 1));
        assertEquals(limit, plan.position(end + 1), 0.001);
        assertEquals(0, plan.velocity(end + 1));
    }

    @Test
    void anEmptyMoveIsOverAtOnce() {
        MotionProfile plan = MotionProfile.to(5, 5, 0, 360, ACCELERATION);
        assertFalse(plan.moves());
        assertTrue(plan.over(0));
        assertEquals(5, plan.position(0));
    }

    @Test
    void anEndlessMoveNeverEnds() {
        MotionProfile plan = MotionProfile.endless(0, 0, -360, ACCELERATION);
        assertEquals(-10.8, plan.position(60), 0.01);
        assertEquals(-360, plan.velocity(60), 0.01);
        assertEquals(-10.8 - 360 * 99.94, plan.position(100_000), 0.1);
        assertFalse(plan.over(Integer.MAX_VALUE));
        assertFalse(plan.braking(1_000_000));
    }

    @Test
    void aStopTakesTheBrakingDistance() {
        MotionProfile plan = MotionProfile.stop(10, 360, 1000);
        assertEquals(360, plan.endMillis(), 1);
        assertEquals(74.8, plan.position(361), 0.01);
        assertEquals(180, plan.velocity(180), 0.01);
        assertEquals(-54.8, MotionProfile.stop(10, -360, 1000).position(361), 0.01);
    }

    @Test
    void everyPlanIsContinuousAndEndsAtItsLimit() {
        for (int i = 0; i < 5 * 7 * 5 * 4; i++) {
            double velocity = (i % 5 - 2) * 300;
            double limit = new double[] {-1000, -30, -1, 0, 1, 30, 1000}[i / 5 % 7];
            double speed = new double[] {1, 90, 360, 800, 2000}[i / 35 % 5];
            double acceleration = new double[] {300, 1000, 6000, 20_000}[i / 175 % 4];
            MotionProfile plan = MotionProfile.to(limit, 0, velocity, speed, acceleration);
            double fastest = Math.max(Math.abs(velocity), speed);
            double before = plan.position(0);
            for (int t = 1; t <= plan.endMillis() + 1 && t < 20_000; t++) {
                double now = plan.position(t);
                assertEquals(before, now, fastest / 1000 * 2 + acceleration * 1e-6 + 1e-6, "case " + i + " at " + t);
                before = now;
            }
            assertEquals(limit, plan.position(Integer.MAX_VALUE - 1), 1e-9, "case " + i);
        }
    }
}
