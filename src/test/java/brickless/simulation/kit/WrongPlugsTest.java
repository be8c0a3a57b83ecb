package brickless.simulation.kit;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.simulation.Run;
import java.util.function.UnaryOperator;
import kit.WrongPlugs;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The original's exceptions, with a cause that says what is plugged in and what to change. */
class WrongPlugsTest {
    private static Printed lines;
    private static String summary;

    @BeforeAll
    static void run() {
        try (Run run = Kit.run(WrongPlugs.class, Kit.EMPTY, Worlds.EV3, UnaryOperator.identity())) {
            lines = Kit.printed(run);
            summary = run.report().text();
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "wrongSensor | IllegalArgumentException: Invalid sensor mode IllegalStateException: S1 has ev3-touch "
                + "plugged in, but the program wants"
            + " EV3UltrasonicSensor there: put data-sensor=\"ev3-ultrasonic\" there in the robot's SVG, open it on "
                    + "S4, where the robot has its"
            + " ev3-ultrasonic, or use --robot auto",
        "afterwards | EV3TouchSensor",
        "taken | DeviceException: unable to open port IllegalStateException: port S1 is open already for "
                + "EV3TouchSensor: use another port, or"
            + " close() the object that holds it",
        "motorPort | IllegalArgumentException: Invalid port interface IllegalStateException: A is a motor port "
                + "(sensors go into S1 to S4) and"
            + " cannot be opened as UARTPort",
        "sensorPort | IllegalArgumentException: Invalid port interface IllegalStateException: S1 is a sensor port "
                + "(motors go into A to D) and"
            + " cannot be opened as TachoMotorPort",
        "bus | I2CException: I2C I/O error IllegalStateException: S2 has ev3-gyro plugged in, but the program wants "
                + "NXTUltrasonicSensor there:"
            + " put data-sensor=\"nxt-ultrasonic\" there in the robot's SVG, or use --robot auto",
        "busAgain | DeviceException: unable to open port IllegalStateException: port S2 is open already for "
                + "NXTUltrasonicSensor: use another"
            + " port, or close() the object that holds it",
        "ready | ExceptionInInitializerError: null DeviceException: unable to open port IllegalStateException: port "
                + "D is open already for"
            + " UnregulatedMotor: use another port, or close() the object that holds it; touching any of Motor.A to "
                    + "Motor.D opens all four motor"
            + " ports, so use either those or motor objects of your own"})
    void failuresSayWhatToChange(String name, String text) {
        assertThat(String.join(" ", lines.words(name))).isEqualTo(text);
    }

    @Test
    void whatLejosDoesNotNoticeIsInTheSummary() {
        assertThat(summary).contains("no motor is plugged into D, so the program's UnregulatedMotor there never turns",
                "ev3-gyro is plugged into S2; the program uses NXTUltrasonicSensor there");
    }
}
