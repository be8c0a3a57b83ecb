package lejos.robotics.navigation;

import lejos.robotics.EncoderMotor;
import lejos.robotics.Gyroscope;

/**
 * A robot that balances on a ball. A virtual robot stands on a flat world without gravity and cannot: there is no way
 * to make one.
 */
public class Ballbot extends Thread {
    private static final String REASON = "a robot cannot balance on a ball: the simulated world has no third dimension";

    /** A motor that drives the ball. */
    protected EncoderMotor my_motor;

    /**
     * Not possible.
     *
     * @throws UnsupportedOperationException always
     */
    public Ballbot(EncoderMotor xMotor, Gyroscope xGyro, EncoderMotor yMotor, Gyroscope yGyro, double rollerDiameter) {
        throw new UnsupportedOperationException(REASON);
    }

    /**
     * Not possible.
     *
     * @throws UnsupportedOperationException always
     */
    @Override
    public void run() {
        throw new UnsupportedOperationException(REASON);
    }

    /**
     * Not possible.
     *
     * @throws UnsupportedOperationException always
     */
    public void impulseMove(int x, int y) {
        throw new UnsupportedOperationException(REASON);
    }
}
