package lejos.internal.ev3;

import java.util.List;
import lejos.hardware.port.IOPort;

/**
 * The eight ports of the local EV3. There is one port object per socket; every way to a port leads to the same object.
 */
public final class EV3Ports {
    private static final List<EV3Port> SENSOR_PORTS = List.of(
            new EV3Port("S1", EV3Port.SENSOR_PORT, 0), new EV3Port("S2", EV3Port.SENSOR_PORT, 1),
            new EV3Port("S3", EV3Port.SENSOR_PORT, 2), new EV3Port("S4", EV3Port.SENSOR_PORT, 3));
    private static final List<EV3Port> MOTOR_PORTS = List.of(
            new EV3Port("A", EV3Port.MOTOR_PORT, 0), new EV3Port("B", EV3Port.MOTOR_PORT, 1),
            new EV3Port("C", EV3Port.MOTOR_PORT, 2), new EV3Port("D", EV3Port.MOTOR_PORT, 3));

    private EV3Ports() {}

    /**
     * An input port.
     *
     * @param index 0 to 3 for S1 to S4
     */
    public static EV3Port sensorPort(int index) {
        return SENSOR_PORTS.get(index);
    }

    /**
     * An output port.
     *
     * @param index 0 to 3 for A to D
     */
    public static EV3Port motorPort(int index) {
        return MOTOR_PORTS.get(index);
    }

    /**
     * Tells the simulator which leJOS class is about to use an opened port, so that it can plug the matching device
     * into a fitted robot and name the class in messages. Ports that are not this brick's are ignored.
     *
     * @param port the opened port
     * @param device the motor or sensor object; a subclass of the program counts as the leJOS class it extends
     */
    public static void announce(IOPort port, Object device) {
        if (port instanceof EV3IOPort opened) {
            String lejosClass = lejosClass(device.getClass()).getSimpleName();
            String ownClass = device.getClass().getSimpleName();
            opened.announce(lejosClass, ownClass.isEmpty() ? lejosClass : ownClass);
        }
    }

    /**
     * Why a device cannot be talked to, as a cause for an exception whose text is fixed by leJOS; null for a port that
     * is not this brick's.
     */
    public static Throwable mismatch(IOPort port) {
        return port instanceof EV3IOPort opened ? new IllegalStateException(opened.describePlug()) : null;
    }

    private static Class<?> lejosClass(Class<?> type) {
        Class<?> candidate = type;
        while (candidate.getSuperclass() != null && !candidate.getName().startsWith("lejos.hardware.")) {
            candidate = candidate.getSuperclass();
        }
        return candidate;
    }
}
