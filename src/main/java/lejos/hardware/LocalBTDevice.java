package lejos.hardware;

import brickless.hardware.BrickAccess;
import java.util.ArrayList;
import java.util.Collection;
import lejos.internal.io.NativeHCI;
import lejos.utility.Delay;

/** The brick's Bluetooth radio. Nothing is in range of a virtual brick: searches take their time and find nothing. */
public class LocalBTDevice {
    private static final int INQUIRY_MILLIS = 10_000;
    private static final String NOBODY_IN_RANGE = "no Bluetooth device is in range of a virtual brick: ";

    private static boolean visible = true;

    /** The radio of the local brick. */
    public LocalBTDevice() {}

    /** Searches for devices; blocks for 10 s. */
    public Collection<RemoteBTDevice> search() {
        Delay.msDelay(INQUIRY_MILLIS);
        return new ArrayList<>();
    }

    /** Devices that are paired with this brick: none. */
    public Collection<RemoteBTDevice> getPairedDevices() {
        return new ArrayList<>();
    }

    /** Lets other devices find this one, or not. */
    public void setVisibility(boolean visible) {
        setVisible(visible);
    }

    private static synchronized void setVisible(boolean newVisible) {
        visible = newVisible;
    }

    /** Whether other devices may find this one. */
    public boolean getVisibility() {
        return isVisible();
    }

    private static synchronized boolean isVisible() {
        return visible;
    }

    /** Whether the radio is on: always. */
    public static boolean isPowerOn() {
        return true;
    }

    /** Address of this radio as text. */
    public String getBluetoothAddress() {
        return Bluetooth.getAddress(getDeviceInfo().bdaddr);
    }

    /** Name of this brick. */
    public String getFriendlyName() {
        return BrickAccess.brick().name();
    }

    /** Description of the radio. */
    public NativeHCI.DeviceInfo getDeviceInfo() {
        return new NativeHCI.DeviceInfo();
    }

    /** Versions of the radio. */
    public NativeHCI.LocalVersion getLocalVersion() {
        return new NativeHCI.LocalVersion();
    }

    /**
     * Pairs with a device.
     *
     * @throws BluetoothException always, because no device is in range
     */
    public void authenticate(String deviceAddress, String pin) {
        throw new BluetoothException(NOBODY_IN_RANGE + deviceAddress);
    }

    /**
     * Forgets a paired device.
     *
     * @throws BluetoothException always, because no device is paired
     */
    public void removeDevice(String deviceAddress) {
        throw new BluetoothException(NOBODY_IN_RANGE + deviceAddress);
    }

    /** Ends the use of the radio; it can be used again. */
    public void disconnect() {
        // Holds nothing open.
    }
}
