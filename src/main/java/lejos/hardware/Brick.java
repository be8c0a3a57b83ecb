package lejos.hardware;

import lejos.hardware.lcd.Font;
import lejos.hardware.lcd.GraphicsLCD;
import lejos.hardware.lcd.TextLCD;
import lejos.hardware.port.Port;
import lejos.hardware.video.Video;

/** A programmable brick and what belongs to it. */
public interface Brick {
    /**
     * A port by name: {@code "S1"} to {@code "S4"} or {@code "A"} to {@code "D"}.
     *
     * @throws IllegalArgumentException if there is no such port
     */
    Port getPort(String portName);

    /** The battery. */
    Power getPower();

    /** The loudspeaker. */
    Audio getAudio();

    /** The camera. */
    Video getVideo();

    /** The display as text in the default font; the same object on every call. */
    TextLCD getTextLCD();

    /** The display as text in the given font; a new object on every call. */
    TextLCD getTextLCD(Font f);

    /** The display for graphics; the same object on every call. */
    GraphicsLCD getGraphicsLCD();

    /** Whether this program runs on the brick. */
    boolean isLocal();

    /** Type of the brick, e.g. {@code "EV3"}. */
    String getType();

    /** Name of the brick. */
    String getName();

    /** The Bluetooth device. */
    LocalBTDevice getBluetoothDevice();

    /** The WiFi device. */
    LocalWifiDevice getWifiDevice();

    /** Makes this the brick that {@link BrickFinder#getDefault()} returns from now on. */
    void setDefault();

    /** All keys together. */
    Keys getKeys();

    /**
     * A key by name: {@code Up}, {@code Enter}, {@code Down}, {@code Right}, {@code Left} or {@code Escape}.
     *
     * @throws ArrayIndexOutOfBoundsException if there is no such key
     */
    Key getKey(String name);

    /** The LEDs behind the keys. */
    LED getLED();
}
