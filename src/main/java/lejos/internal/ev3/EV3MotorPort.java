package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import brickless.hardware.MotorSocket;
import lejos.hardware.motor.MotorRegulator;
import lejos.hardware.port.TachoMotorPort;

/** An opened output port. Direct drive and the regulator are not arbitrated: the last command wins. */
public class EV3MotorPort extends EV3IOPort implements TachoMotorPort {
    private MotorSocket socket;
    private EV3MotorRegulator regulator;

    /** A port that is not open yet. */
    public EV3MotorPort() {}

    @Override
    protected void connect() {
        socket = BrickAccess.brick().motor(port);
    }

    @Override
    protected void disconnect() {
        socket.release();
    }

    @Override
    public void close() {
        super.close();
        EV3MotorRegulator closed;
        synchronized (this) {
            closed = regulator;
        }
        if (closed != null) {
            closed.portClosed();
        }
    }

    @Override
    void announce(String lejosClass, String ownClass) {
        super.announce(lejosClass, ownClass);
        socket.expect(lejosClass);
    }

    @Override
    String describePlug() {
        return socket.connected() + " is plugged into " + getName();
    }

    /** The output socket. */
    MotorSocket socket() {
        requireOpen();
        return socket;
    }

    /** 0 to 3, −1 when closed. */
    int index() {
        return port;
    }

    /** {@inheritDoc} The power is narrowed to a signed byte, as in the original: 200 means −56. */
    @Override
    public synchronized void controlMotor(int power, int mode) {
        switch (mode) {
            case BACKWARD:
                socket().drive((byte) -power);
                break;
            case FLOAT:
                socket().coast();
                break;
            default:
                if (mode >= STOP) {
                    socket().brake();
                } else {
                    socket().drive((byte) power);
                }
                break;
        }
    }

    @Override
    public int getTachoCount() {
        return socket().tachoDegrees();
    }

    @Override
    public synchronized void resetTachoCount() {
        socket().resetTacho();
    }

    @Override
    public void setPWMMode(int mode) {
        // An EV3 always brakes between pulses.
    }

    @Override
    public synchronized MotorRegulator getRegulator() {
        if (regulator == null) {
            regulator = new EV3MotorRegulator(this);
        }
        return regulator;
    }
}
