package lejos.hardware.motor;

import lejos.hardware.port.BasicMotorPort;
import lejos.hardware.port.TachoMotorPort;

/** A port with a motor of first order: 850 deg/s at full power, 60 ms time constant, one period of 4 ms per command. */
final class SimulatedMotorPort implements TachoMotorPort {
    private static final double SPEED_PER_PERCENT = 8.5;
    private static final double SHARE_PER_PERIOD = 4.0 / 60;
    private static final double PERIOD_SECONDS = 0.004;

    private double degrees;
    private double speed;
    private boolean blocked;
    private int lastMode;
    private int pwmMode = -1;
    private int looks;

    synchronized void block() {
        blocked = true;
    }

    /** Blocks until the motor has turned that far forward. */
    synchronized void awaitDegrees(int wanted) throws InterruptedException {
        while (degrees < wanted) {
            wait();
        }
    }

    synchronized int lastMode() {
        return lastMode;
    }

    synchronized int pwmMode() {
        return pwmMode;
    }

    @Override
    public synchronized void controlMotor(int power, int mode) {
        lastMode = mode;
        double duty = mode == BasicMotorPort.FORWARD ? power : mode == BasicMotorPort.BACKWARD ? -power : 0;
        speed += (duty * SPEED_PER_PERCENT - speed) * SHARE_PER_PERIOD;
        if (!blocked) {
            degrees += speed * PERIOD_SECONDS;
        }
        notifyAll();
    }

    @Override
    public synchronized void setPWMMode(int mode) {
        pwmMode = mode;
    }

    /** How often the encoder was read. */
    synchronized int looks() {
        return looks;
    }

    @Override
    public synchronized int getTachoCount() {
        looks++;
        return (int) Math.round(degrees);
    }

    @Override
    public synchronized void resetTachoCount() {
        degrees = 0;
    }

    @Override
    public MotorRegulator getRegulator() {
        throw new IllegalStateException("the test brings its own regulator");
    }

    @Override
    public void close() {
        lastMode = BasicMotorPort.FLOAT;
    }

    @Override
    public String getName() {
        return "simulated";
    }

    @Override
    public boolean setPinMode(int mode) {
        return false;
    }
}
