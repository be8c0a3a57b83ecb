package lejos.utility;

import java.util.Locale;
import lejos.hardware.device.IRTransmitter;
import lejos.hardware.port.I2CPort;
import lejos.hardware.sensor.HiTechnicAccelerometer;
import lejos.hardware.sensor.I2CSensor;
import lejos.hardware.sensor.MindsensorsAccelerometer;
import lejos.hardware.sensor.SensorMode;

/** Chooses a driver by the maker's name that a device on an I²C bus tells. */
public class SensorSelector {
    /** Not needed: all methods are static. */
    public SensorSelector() {}

    /**
     * The acceleration mode of whatever accelerometer is on the bus.
     *
     * @throws SensorSelectorException if its maker is unknown, or nothing answers
     */
    public static SensorMode createAccelerometer(I2CPort port) throws SensorSelectorException {
        switch (maker(port)) {
            case "mndsnsrs":
                return new MindsensorsAccelerometer(port).getAccelerationMode();
            case "hitechnc":
                return new HiTechnicAccelerometer(port).getAccelerationMode();
            default:
                throw new SensorSelectorException("No Such Sensor");
        }
    }

    /**
     * The infrared transmitter on the bus. There is no driver for any of them yet.
     *
     * @throws SensorSelectorException always
     */
    public static IRTransmitter createIRTransmitter(I2CPort port) throws SensorSelectorException {
        String maker = maker(port);
        throw new SensorSelectorException(maker.isEmpty() ? "No Such Sensor" : "No Such Sensor: " + maker);
    }

    private static String maker(I2CPort port) {
        return new I2CSensor(port).getVendorID().toLowerCase(Locale.ROOT);
    }
}
