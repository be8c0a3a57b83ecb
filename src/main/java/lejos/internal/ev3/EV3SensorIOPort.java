package lejos.internal.ev3;

import brickless.hardware.BrickAccess;
import brickless.hardware.SensorSocket;

/** An opened input port, whatever channel it uses. */
abstract class EV3SensorIOPort extends EV3IOPort {
    private SensorSocket socket;

    @Override
    protected void connect() {
        socket = BrickAccess.brick().sensor(port);
    }

    @Override
    protected void disconnect() {
        socket.release();
    }

    @Override
    void announce(String lejosClass, String ownClass) {
        super.announce(lejosClass, ownClass);
        socket.expect(lejosClass);
    }

    /** The input socket. */
    SensorSocket socket() {
        requireOpen();
        return socket;
    }

    @Override
    String describePlug() {
        return SensorPlug.describe(getName(), socket, lejosClass(), user());
    }
}
