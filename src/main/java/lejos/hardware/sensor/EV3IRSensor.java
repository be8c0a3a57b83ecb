package lejos.hardware.sensor;

import lejos.hardware.port.Port;
import lejos.hardware.port.UARTPort;

/** The EV3 infrared sensor: mode 0 "Distance" to an object, mode 1 "Seek" for four beacons, and the remote control. */
public class EV3IRSensor extends UARTSensor {
    /** Hardware mode of the distance measurement. */
    protected static final int IR_PROX = 0;
    /** Hardware mode of the beacon search. */
    protected static final int IR_SEEK = 1;
    /** Hardware mode of the remote control. */
    protected static final int IR_REMOTE = 2;
    /** Kept for subclasses; the device itself tells when it is ready. */
    protected static final int SWITCH_DELAY = 250;
    /** Number of channels of beacons and remote controls. */
    public static final int IR_CHANNELS = 4;

    private static final int NEAREST = 5;
    private static final int FARTHEST = 55;
    /** Distance byte of a channel on which no beacon is seen. */
    private static final int NO_BEACON = 128;

    /** The commands read last, one per channel. */
    protected byte[] remoteVals = new byte[IR_CHANNELS];

    /**
     * A sensor on an open port, which {@link #close()} leaves open.
     *
     * @throws lejos.hardware.DeviceException if no serial sensor answers
     */
    public EV3IRSensor(UARTPort port) {
        super(port, IR_PROX);
        init();
    }

    /**
     * A sensor on a port that is opened now and closed with the sensor; blocks until it sends data.
     *
     * @throws lejos.hardware.DeviceException if the port is open already
     * @throws IllegalArgumentException if no serial sensor answers
     */
    public EV3IRSensor(Port port) {
        super(port, IR_PROX);
        init();
    }

    /** Sets the modes. */
    protected void init() {
        setModes(new SensorMode[] {new DistanceMode(), new SeekMode()});
    }

    /**
     * The buttons pressed on a remote control: 0 none, 1 top left, 2 bottom left, 3 top right, 4 bottom right, 5 both
     * tops, 6 top left and bottom right, 7 bottom left and top right, 8 both bottoms, 9 beacon, 10 both left, 11 both
     * right. May block for a switch of mode.
     *
     * @param chan channel 0 to 3
     */
    public int getRemoteCommand(int chan) {
        switchMode(IR_REMOTE, SWITCH_DELAY);
        port.getBytes(remoteVals, 0, IR_CHANNELS);
        return remoteVals[chan] & 0xff;
    }

    /** The buttons pressed on the remote controls of the first {@code len} channels. May block for a switch of mode. */
    public void getRemoteCommands(byte[] cmds, int offset, int len) {
        switchMode(IR_REMOTE, SWITCH_DELAY);
        port.getBytes(cmds, offset, len);
    }

    /** Mode "Distance": 5 to 55, very roughly centimetres; 0 if nearer, positive infinity if farther. */
    public SensorMode getDistanceMode() {
        return getMode(0);
    }

    /**
     * Mode "Seek": for each channel the bearing of the beacon (−25 to 25, right positive) and its distance (0 to 100 or
     * infinity).
     */
    public SensorMode getSeekMode() {
        return getMode(1);
    }

    private final class DistanceMode implements SensorMode {
        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchMode(IR_PROX, SWITCH_DELAY);
            int raw = port.getByte() & 0xff;
            sample[offset] = raw < NEAREST ? 0 : raw > FARTHEST ? Float.POSITIVE_INFINITY : raw;
        }

        @Override
        public String getName() {
            return "Distance";
        }
    }

    private final class SeekMode implements SensorMode {
        @Override
        public int sampleSize() {
            return 2 * IR_CHANNELS;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchMode(IR_SEEK, SWITCH_DELAY);
            byte[] beacons = new byte[2 * IR_CHANNELS];
            port.getBytes(beacons, 0, beacons.length);
            for (int i = 0; i < beacons.length; i += 2) {
                int distance = beacons[i + 1] & 0xff;
                boolean seen = distance != NO_BEACON;
                sample[offset + i] = seen ? beacons[i] : 0;
                sample[offset + i + 1] = seen ? distance : Float.POSITIVE_INFINITY;
            }
        }

        @Override
        public String getName() {
            return "Seek";
        }
    }
}
