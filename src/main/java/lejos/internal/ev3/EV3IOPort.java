package lejos.internal.ev3;

import lejos.hardware.port.BasicSensorPort;
import lejos.hardware.port.IOPort;
import lejos.hardware.sensor.EV3SensorConstants;

/**
 * An opened port, and the table of all opened ports of the program: a physical port can be open once at a time.
 *
 * <p>The table is guarded by the lock of this class. A closed port object stays closed.
 */
public abstract class EV3IOPort implements IOPort, BasicSensorPort, EV3SensorConstants {
    private static final String READY_MADE_MOTORS =
            "; touching any of Motor.A to Motor.D opens all four motor ports, so use either those or motor objects "
                    + "of your own";
    private static final EV3IOPort[][] OPEN = {new EV3IOPort[PORTS], new EV3IOPort[MOTORS]};

    /** 0 to 3; −1 when closed. */
    protected int port = -1;
    /** {@link EV3Port#SENSOR_PORT} or {@link EV3Port#MOTOR_PORT}. */
    protected int typ = -1;
    /** The port this was opened from. */
    protected EV3Port ref;
    /** The mode set last. */
    protected int currentMode;

    private volatile String lejosClass;
    private volatile String user;

    /** A port that is not open yet. */
    protected EV3IOPort() {}

    /**
     * Occupies a physical port.
     *
     * @return false if it is open already
     */
    public boolean open(int type, int index, EV3Port origin) {
        synchronized (EV3IOPort.class) {
            if (OPEN[type][index] != null) {
                return false;
            }
            OPEN[type][index] = this;
            typ = type;
            port = index;
            ref = origin;
        }
        connect();
        return true;
    }

    @Override
    public void close() {
        synchronized (EV3IOPort.class) {
            if (port < 0) {
                return;
            }
            disconnect();
            OPEN[typ][port] = null;
            port = -1;
        }
    }

    /** Closes every port that the program has open. */
    public static void closeAll() {
        synchronized (EV3IOPort.class) {
            for (EV3IOPort[] kind : OPEN) {
                for (EV3IOPort opened : kind) {
                    if (opened != null) {
                        opened.close();
                    }
                }
            }
        }
    }

    /** Who holds a port, as the cause of a refusal. */
    static Throwable occupation(int type, int index) {
        synchronized (EV3IOPort.class) {
            EV3IOPort holder = OPEN[type][index];
            return holder == null ? null : new IllegalStateException("port " + holder.getName() + " is open already"
                    + (holder.user == null ? "" : " for " + holder.user)
                    + ": use another port, or close() the object that holds it"
                    + (type == EV3Port.MOTOR_PORT ? READY_MADE_MOTORS : ""));
        }
    }

    /** Finds the sockets of the brick when the port has been occupied. */
    protected abstract void connect();

    /** Frees the sockets of the brick before the port becomes free. */
    protected abstract void disconnect();

    /** What is plugged in and what the program expected there, in a sentence or two. */
    abstract String describePlug();

    /** Notes which leJOS class uses the port, and which class of the program that is. */
    void announce(String name, String ownClass) {
        lejosClass = name;
        user = ownClass;
    }

    /** The leJOS class that uses the port, or null. */
    String lejosClass() {
        return lejosClass;
    }

    /** The class that uses the port: the program's own or that of leJOS; or null. */
    String user() {
        return user;
    }

    /**
     * The original read its device memory at index −1 after a close; programs get the same exception with an
     * explanation.
     */
    void requireOpen() {
        if (port < 0) {
            throw new IndexOutOfBoundsException("port " + getName() + " has been closed");
        }
    }

    @Override
    public String getName() {
        return ref == null ? "closed port" : ref.getName();
    }

    @Override
    public int getMode() {
        return currentMode;
    }

    @Override
    public int getType() {
        return 0;
    }

    @Override
    public boolean setMode(int mode) {
        currentMode = mode;
        return true;
    }

    @Override
    public boolean setType(int type) {
        throw new UnsupportedOperationException("port " + getName() + " has no types");
    }

    @Override
    @Deprecated
    public boolean setTypeAndMode(int type, int mode) {
        setType(type);
        setMode(mode);
        return true;
    }

    /** Accepts everything: a virtual device does not look at single pins. */
    @Override
    public boolean setPinMode(int mode) {
        return true;
    }
}
