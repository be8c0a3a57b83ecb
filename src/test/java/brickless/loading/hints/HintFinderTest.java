package brickless.loading.hints;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import lejos.hardware.BrickFinder;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.motor.Motor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.Port;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.chassis.Chassis;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import org.junit.jupiter.api.Test;

class HintFinderTest {
    private static HardwareHints hintsOf(Class<?>... classes) throws IOException {
        List<byte[]> files = new ArrayList<>();
        for (Class<?> type : classes) {
            try (InputStream in = type.getResourceAsStream(type.getName().substring(type.getName().lastIndexOf('.') + 1)
                    + ".class")) {
                files.add(in.readAllBytes());
            }
        }
        return HintFinder.find(files);
    }

    static class Direct {
        static final double DIAMETER = 5.6;
        RegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.A);
        RegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.D);
        EV3TouchSensor touch = new EV3TouchSensor(SensorPort.S2);

        void build() {
            Wheel one = WheeledChassis.modelWheel(left, DIAMETER).offset(-12.0 / 2);
            Wheel two = WheeledChassis.modelWheel(right, DIAMETER).offset(12.0 / 2);
            Chassis chassis = new WheeledChassis(new Wheel[] {one, two}, WheeledChassis.TYPE_DIFFERENTIAL);
            chassis.stop();
        }
    }

    @Test
    void fieldsAndChassis() throws IOException {
        HardwareHints hints = hintsOf(Direct.class);
        assertThat(hints.motors()).containsExactly(new HardwareHints.Device("A", "EV3LargeRegulatedMotor", "left"),
                new HardwareHints.Device("D", "EV3LargeRegulatedMotor", "right"));
        assertThat(hints.sensors()).containsExactly(new HardwareHints.Device("S2", "EV3TouchSensor", "touch"));
        assertThat(hints.wheels()).extracting(HardwareHints.Wheel::port).containsExactly("A", "D");
        assertThat(hints.wheels()).extracting(HardwareHints.Wheel::diameter).containsExactly(5.6, 5.6);
        assertThat(hints.wheels()).extracting(wheel -> wheel.offset().getAsDouble()).containsExactly(-6.0, 6.0);
    }

    static class Indirect {
        private static final String EYE = "S3";
        private final Port armPort;
        private EV3MediumRegulatedMotor arm;

        Indirect(Port armPort) {
            this.armPort = armPort;
        }

        static void start() {
            Indirect robot = new Indirect(BrickFinder.getDefault().getPort("C"));
            robot.open();
            sensorAt(BrickFinder.getDefault().getPort(EYE));
        }

        void open() {
            arm = new EV3MediumRegulatedMotor(armPort);
            arm.forward();
        }

        static EV3ColorSensor sensorAt(Port port) {
            return new EV3ColorSensor(port);
        }
    }

    @Test
    void portsThatTravelThroughFieldsArgumentsAndConstants() throws IOException {
        HardwareHints hints = hintsOf(Indirect.class);
        assertThat(hints.motors()).containsExactly(new HardwareHints.Device("C", "EV3MediumRegulatedMotor", "arm"));
        assertThat(hints.sensors()).extracting(HardwareHints.Device::port).containsExactly("S3");
    }

    static class Shared {
        static void start() {
            open(MotorPort.A);
            open(MotorPort.B);
        }

        static void open(Port port) {
            new EV3LargeRegulatedMotor(port).forward();
        }
    }

    @Test
    void oneConstructorCallMayOpenSeveralPorts() throws IOException {
        assertThat(hintsOf(Shared.class).motors()).extracting(HardwareHints.Device::port).containsExactly("A", "B");
    }

    static class Ready {
        static void start() {
            Motor.B.forward();
            Motor.C.forward();
        }
    }

    @Test
    void readyMadeMotorsCount() throws IOException {
        assertThat(hintsOf(Ready.class).motors()).extracting(HardwareHints.Device::port).containsExactly("B", "C");
    }

    @Test
    void aClassWithoutHardwareGivesNone() throws IOException {
        assertThat(hintsOf(String.class)).usingRecursiveComparison().ignoringFields("numbers")
                .isEqualTo(new HardwareHints(List.of(), List.of(), List.of()));
    }
}
