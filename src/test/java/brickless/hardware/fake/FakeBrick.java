package brickless.hardware.fake;

import brickless.hardware.BrickHardware;
import brickless.hardware.KeySocket;
import brickless.hardware.LedSocket;
import brickless.hardware.MoveRequest;
import brickless.hardware.PowerSocket;
import brickless.hardware.ProgramLog;
import brickless.hardware.ScreenSocket;
import brickless.hardware.SpeakerSocket;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A brick with four perfect motors, four scripted sensors and silent everything else. */
public final class FakeBrick implements BrickHardware {
    private final List<FakeMotor> motors = new ArrayList<>();
    private final List<FakeSensor> sensors = new ArrayList<>();
    private final List<String> groups = new ArrayList<>();
    private volatile float volts = 8.0f;

    /** A brick at 8 V with motors that have not moved and empty input ports. */
    public FakeBrick() {
        for (int i = 0; i < 4; i++) {
            motors.add(new FakeMotor(this));
            sensors.add(new FakeSensor());
        }
    }

    /** Lets time pass for all motors. */
    public void advance(int millis) {
        for (int i = 0; i < millis; i++) {
            motors.forEach(FakeMotor::millisecond);
        }
    }

    /** Sets the battery's voltage. */
    public void setVolts(float volts) {
        this.volts = volts;
    }

    /** The ports of each synchronised start so far, e.g. {@code "[1, 2]"}. */
    public List<String> groups() {
        return groups;
    }

    @Override
    public FakeMotor motor(int index) {
        return motors.get(index);
    }

    @Override
    public FakeSensor sensor(int index) {
        return sensors.get(index);
    }

    @Override
    public void moveTogether(int[] ports, MoveRequest[] requests) {
        groups.add(Arrays.toString(ports));
        for (int i = 0; i < ports.length; i++) {
            motor(ports[i]).regulation().move(requests[i]);
        }
    }

    @Override
    public String name() {
        return "EV3";
    }

    @Override
    public PowerSocket power() {
        return new PowerSocket() {
            @Override
            public float voltageVolts() {
                return volts;
            }

            @Override
            public float batteryCurrentAmperes() {
                return 0;
            }

            @Override
            public float motorCurrentAmperes() {
                return 0;
            }
        };
    }

    @Override
    public ScreenSocket screen() {
        return Silent.socket(ScreenSocket.class);
    }

    @Override
    public KeySocket keys() {
        return Silent.socket(KeySocket.class);
    }

    @Override
    public LedSocket leds() {
        return Silent.socket(LedSocket.class);
    }

    @Override
    public SpeakerSocket speaker() {
        return Silent.socket(SpeakerSocket.class);
    }

    @Override
    public ProgramLog log() {
        return Silent.socket(ProgramLog.class);
    }
}
