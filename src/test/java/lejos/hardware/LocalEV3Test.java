package lejos.hardware;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import brickless.device.panel.PanelBench;
import java.io.IOException;
import lejos.hardware.ev3.EV3;
import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.lcd.Font;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.video.Video;
import lejos.internal.ev3.EV3LED;
import lejos.internal.io.Settings;
import lejos.internal.io.SystemSettings;
import lejos.realm.OnPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(OnPanel.class)
class LocalEV3Test {
    private PanelBench bench;

    @Test
    void thereIsOneBrickHoweverItIsFound() {
        EV3 brick = LocalEV3.get();
        assertThat(brick).isSameAs(LocalEV3.ev3).isSameAs(BrickFinder.getLocal()).isSameAs(BrickFinder.getDefault());
        assertThat(brick.getName()).isEqualTo("bench");
        assertThat(brick.getType()).isEqualTo("EV3");
        assertThat(brick.isLocal()).isTrue();
    }

    @Test
    void displaysKeysAndSoundAreSingletonsAndFontDisplaysAreNot() {
        EV3 brick = LocalEV3.get();
        assertThat(brick.getTextLCD()).isSameAs(brick.getTextLCD());
        assertThat(brick.getGraphicsLCD()).isSameAs(brick.getGraphicsLCD());
        assertThat(brick.getTextLCD(Font.getSmallFont())).isNotSameAs(brick.getTextLCD(Font.getSmallFont()));
        assertThat(brick.getGraphicsLCD().getDisplay()).isSameAs(brick.getTextLCD().getDisplay());
        assertThat(brick.getKeys()).isSameAs(Button.keys);
        assertThat(brick.getKey("Enter")).isSameAs(Button.ENTER);
        assertThat(brick.getAudio()).isSameAs(brick.getAudio());
    }

    @Test
    void portsAreTheObjectsOfThePortInterfaces() {
        assertThat(LocalEV3.get().getPort("S3")).isSameAs(SensorPort.S3);
        assertThat(LocalEV3.get().getPort("D")).isSameAs(MotorPort.D);
    }

    @Test
    void unknownPortsAndKeysAreRefused() {
        for (String name : new String[] {"S5", "a", "s1", "", null}) {
            assertThatThrownBy(() -> LocalEV3.get().getPort(name)).isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("No such port " + name);
        }
        assertThatThrownBy(() -> LocalEV3.get().getKey("ENTER")).isInstanceOf(ArrayIndexOutOfBoundsException.class);
    }

    @Test
    void batteryReportsTheSocketsValues() {
        bench.setVolts(7.25f);
        assertThat(Battery.getVoltage()).isEqualTo(7.25f);
        assertThat(Battery.getVoltageMilliVolt()).isEqualTo(7250);
        assertThat(Battery.getBatteryCurrent()).isEqualTo(0.5f);
        assertThat(Battery.getMotorCurrent()).isEqualTo(0.25f);
    }

    @Test
    void searchesTakeTheirTimeAndFindNobody() {
        assertThat(BrickFinder.discover()).isEmpty();
        assertThat(bench.millis()).isCloseTo(2000, within(1.0));
        assertThat(BrickFinder.find("EV3")).isEmpty();
        assertThat(BrickFinder.discoverNXT()).isEmpty();
        assertThat(bench.millis()).isCloseTo(14_000, within(1.0));
    }

    @Test
    void aBrickFoundIsDescribed() {
        BrickInfo found = new BrickInfo("Greta", "10.0.1.1", "EV3");
        assertThat(found.getName()).isEqualTo("Greta");
        assertThat(found.getIPAddress()).isEqualTo("10.0.1.1");
        assertThat(found.getType()).isEqualTo("EV3");
    }

    @Test
    void theBrickOfThisProgramIsTheDefaultUnlessAnotherIsChosen() {
        Brick brick = BrickFinder.getDefault();
        BrickFinder.setDefault(brick);
        assertThat(BrickFinder.getDefault()).isSameAs(brick).isSameAs(BrickFinder.getLocal());
        brick.setDefault();
        assertThat(BrickFinder.getDefault()).isSameAs(brick);
    }

    @Test
    void failuresOfDevicesNeedNotBeCaught() {
        IllegalStateException cause = new IllegalStateException("why");
        assertThat(new DeviceException("what", cause)).hasMessage("what").hasCause(cause)
                .isInstanceOf(RuntimeException.class);
        assertThat(new DeviceException(cause)).hasCause(cause);
        assertThat(new DeviceException()).hasMessage(null);
        assertThat(new BluetoothException("what", cause)).hasMessage("what").hasCause(cause)
                .isInstanceOf(RuntimeException.class);
    }

    @Test
    void ledColoursAndPatternsMakeNumbers() {
        EV3LED led = new EV3LED();
        led.setPattern(EV3LED.COLOR_RED, EV3LED.PATTERN_HEARTBEAT);
        led.setPattern(EV3LED.COLOR_GREEN, EV3LED.PATTERN_ON);
        led.setPattern(EV3LED.COLOR_NONE, EV3LED.PATTERN_BLINK);
        assertThat(bench.events()).containsExactly("led 8", "led 1", "led 0");
    }

    @Test
    void bluetoothAddressesTurnRoundOnTheirWayToBytes() {
        byte[] bytes = Bluetooth.getAddress("00:16:53:44:97:4F");
        assertThat(bytes).containsExactly(0x4f, 0x97, 0x44, 0x53, 0x16, 0x00);
        assertThat(Bluetooth.getAddress(bytes)).isEqualTo("00:16:53:44:97:4F");
        assertThat(new RemoteBTDevice("x", bytes, 3).getAddress()).isEqualTo("00:16:53:44:97:4F");
    }

    @Test
    void nobodyIsInRadioRange() throws IOException {
        LocalBTDevice radio = Bluetooth.getLocalDevice();
        assertThat(radio.search()).isEmpty();
        assertThat(bench.millis()).isCloseTo(10_000, within(1.0));
        assertThat(radio.getBluetoothAddress()).isEqualTo("00:16:53:00:00:01");
        assertThat(radio.getFriendlyName()).isEqualTo("bench");
        assertThatThrownBy(() -> radio.authenticate("00:16:53:44:97:4F", "1234"))
                .isInstanceOf(BluetoothException.class);
        assertThat(Bluetooth.getNXTCommConnector().connect("NXT", 0)).isNull();
        assertThat(Wifi.getIfNames()).isEmpty();
        assertThat(Wifi.getLocalDevice("wlan0").getAccessPointNames()).isEmpty();
        assertThat(Wifi.getLocalDevice("wlan0").getAccessPoint()).isNull();
    }

    @Test
    void settingsLastForTheRunOnly() {
        assertThat(SystemSettings.getIntSetting("lejos.volume", 33)).isEqualTo(33);
        Settings.setProperty("lejos.volume", "12");
        assertThat(SystemSettings.getIntSetting("lejos.volume", 33)).isEqualTo(12);
        Settings.setProperty("lejos.volume", "loud");
        assertThat(SystemSettings.getIntSetting("lejos.volume", 33)).isEqualTo(33);
        Settings.setProperty("lejos.volume", null);
        assertThat(Settings.getProperty("lejos.volume", "none")).isEqualTo("none");
    }

    @Test
    void thereIsNoCamera() {
        assertThat(Video.PIX_FMT_YUYV).isEqualTo(0x56595559);
        assertThatThrownBy(() -> LocalEV3.get().getVideo().open(160, 120)).isInstanceOf(IOException.class);
    }
}
