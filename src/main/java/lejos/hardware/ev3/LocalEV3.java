package lejos.hardware.ev3;

import brickless.hardware.BrickAccess;
import java.util.ArrayList;
import lejos.hardware.Audio;
import lejos.hardware.Bluetooth;
import lejos.hardware.BrickFinder;
import lejos.hardware.Key;
import lejos.hardware.Keys;
import lejos.hardware.LED;
import lejos.hardware.LocalBTDevice;
import lejos.hardware.LocalWifiDevice;
import lejos.hardware.Power;
import lejos.hardware.Wifi;
import lejos.hardware.lcd.Font;
import lejos.hardware.lcd.GraphicsLCD;
import lejos.hardware.lcd.TextLCD;
import lejos.hardware.port.Port;
import lejos.hardware.video.Video;
import lejos.internal.ev3.EV3Audio;
import lejos.internal.ev3.EV3Battery;
import lejos.internal.ev3.EV3GraphicsLCD;
import lejos.internal.ev3.EV3Key;
import lejos.internal.ev3.EV3Keys;
import lejos.internal.ev3.EV3LCDManager;
import lejos.internal.ev3.EV3LED;
import lejos.internal.ev3.EV3Port;
import lejos.internal.ev3.EV3Ports;
import lejos.internal.ev3.EV3TextLCD;
import lejos.internal.ev3.EV3Video;

/** The EV3 that the program runs on. */
public class LocalEV3 implements EV3 {
    /** Bit of the UP key. */
    public static final int ID_UP = 0x1;
    /** Bit of the ENTER key. */
    public static final int ID_ENTER = 0x2;
    /** Bit of the DOWN key. */
    public static final int ID_DOWN = 0x4;
    /** Bit of the RIGHT key. */
    public static final int ID_RIGHT = 0x8;
    /** Bit of the LEFT key. */
    public static final int ID_LEFT = 0x10;
    /** Bit of the ESCAPE key. */
    public static final int ID_ESCAPE = 0x20;

    /** The only one. */
    public static final LocalEV3 ev3 = new LocalEV3();

    private static final String LAYER = "LCD";
    private static final int PORTS_PER_KIND = 4;

    /** The layers of the screen; null until something is drawn. */
    protected EV3LCDManager lcdManager;
    /** The battery. */
    protected final Power battery = new EV3Battery();
    /** The loudspeaker. */
    protected final Audio audio = EV3Audio.getAudio();
    /** All ports: S1 to S4, then A to D. */
    protected ArrayList<EV3Port> ports = new ArrayList<>();
    /** The screen as text; null until it is asked for. */
    protected TextLCD textLCD;
    /** The screen for graphics; null until it is asked for. */
    protected GraphicsLCD graphicsLCD;
    /** All keys together. */
    protected EV3Keys keys = new EV3Keys();
    /** The LEDs. */
    protected final LED led = new EV3LED();
    /** The camera; null until it is asked for. */
    protected Video video;
    /** The ENTER key. */
    protected final Key enter = new EV3Key(keys, "Enter");
    /** The ESCAPE key. */
    protected final Key escape = new EV3Key(keys, "Escape");
    /** The LEFT key. */
    protected final Key left = new EV3Key(keys, "Left");
    /** The RIGHT key. */
    protected final Key right = new EV3Key(keys, "Right");
    /** The UP key. */
    protected final Key up = new EV3Key(keys, "Up");
    /** The DOWN key. */
    protected final Key down = new EV3Key(keys, "Down");
    /** The keys by position. */
    protected final Key[] keyArray = {up, enter, down, right, left, escape};

    private LocalEV3() {
        for (int i = 0; i < PORTS_PER_KIND; i++) {
            ports.add(EV3Ports.sensorPort(i));
        }
        for (int i = 0; i < PORTS_PER_KIND; i++) {
            ports.add(EV3Ports.motorPort(i));
        }
    }

    /** The brick the program runs on. */
    public static EV3 get() {
        return ev3;
    }

    @Override
    public Port getPort(String portName) {
        for (EV3Port port : ports) {
            if (port.getName().equals(portName)) {
                return port;
            }
        }
        throw new IllegalArgumentException("No such port " + portName);
    }

    @Override
    public Power getPower() {
        return battery;
    }

    /** Makes sure that the screen has its layer. */
    protected synchronized void initLCD() {
        if (lcdManager == null) {
            lcdManager = EV3LCDManager.getLocalLCDManager();
            lcdManager.getLayer(LAYER);
        }
    }

    @Override
    public synchronized TextLCD getTextLCD() {
        if (textLCD == null) {
            textLCD = getTextLCD(Font.getDefaultFont());
        }
        return textLCD;
    }

    @Override
    public synchronized GraphicsLCD getGraphicsLCD() {
        if (graphicsLCD == null) {
            initLCD();
            graphicsLCD = new EV3GraphicsLCD(LAYER);
        }
        return graphicsLCD;
    }

    @Override
    public TextLCD getTextLCD(Font f) {
        initLCD();
        return new EV3TextLCD(LAYER, f);
    }

    @Override
    public Audio getAudio() {
        return audio;
    }

    @Override
    public synchronized Video getVideo() {
        if (video == null) {
            video = new EV3Video();
        }
        return video;
    }

    @Override
    public boolean isLocal() {
        return true;
    }

    @Override
    public String getType() {
        return "EV3";
    }

    @Override
    public String getName() {
        return BrickAccess.brick().name();
    }

    @Override
    public LocalBTDevice getBluetoothDevice() {
        return Bluetooth.getLocalDevice();
    }

    @Override
    public LocalWifiDevice getWifiDevice() {
        return Wifi.getLocalDevice("wlan0");
    }

    @Override
    public void setDefault() {
        BrickFinder.setDefault(this);
    }

    @Override
    public Key getKey(String name) {
        return keyArray[EV3Key.getKeyPos(name)];
    }

    @Override
    public LED getLED() {
        return led;
    }

    @Override
    public Keys getKeys() {
        return keys;
    }
}
