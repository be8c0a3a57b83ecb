package brickless.trace;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.trace.RobotSample.MotorSample;
import brickless.trace.RobotSample.SensorSample;
import brickless.world.Pose2;
import java.io.IOException;
import java.io.StringWriter;
import java.util.List;
import org.junit.jupiter.api.Test;

class SignalsWriterTest {
    private final StringWriter text = new StringWriter();
    private final SignalsWriter writer = new SignalsWriter(text);

    private static RobotSample robot(String name, SensorSample... sensors) {
        return new RobotSample(name, new Pose2(0.5, -0.25, StrictMath.PI / 2),
                List.of(new MotorSample('B', 90, 360.5, -50, 0.125)), List.of(sensors), 8.1);
    }

    private List<String> lines(Sample... samples) throws IOException {
        for (Sample sample : samples) {
            writer.sample(sample);
        }
        writer.close();
        return text.toString().lines().toList();
    }

    private static Sample at(long nanos, RobotSample... robots) {
        return new Sample(nanos, List.of(robots), List.of());
    }

    @Test
    void aRowHasEverySignalOfTheRobot() throws IOException {
        assertThat(lines(at(50_000_000, robot("r", new SensorSample(1, "ev3-touch", new double[] {1})))))
                .containsExactly(
                "time_s,x_m,y_m,heading_deg,B_tacho_deg,B_speed_dps,B_duty_pct,B_current_a,S1_ev3-touch,battery_v",
                "0.05,0.5,-0.25,90,90,360.5,-50,0.125,1,8.1");
    }

    @Test
    void aSensorThatSendsNothingYetHasItsColumn() throws IOException {
        assertThat(lines(at(0, robot("r", new SensorSample(4, "ev3-ultrasonic", new double[0]))),
                at(50_000_000, robot("r", new SensorSample(4, "ev3-ultrasonic", new double[] {2550})))))
                .containsExactly(
                "time_s,x_m,y_m,heading_deg,B_tacho_deg,B_speed_dps,B_duty_pct,B_current_a,S4_ev3-ultrasonic,battery_v",
                "0,0.5,-0.25,90,90,360.5,-50,0.125,,8.1", "0.05,0.5,-0.25,90,90,360.5,-50,0.125,2550,8.1");
    }

    @Test
    void signalsThatComeLaterHaveTheirColumnsAtTheEnd() throws IOException {
        assertThat(lines(at(0, robot("r", new SensorSample(3, "ev3-color", new double[] {7}))),
                at(50_000_000, robot("r", new SensorSample(3, "ev3-color", new double[] {1, 2, 3}))),
                at(100_000_000, robot("r", new SensorSample(3, "ev3-color", new double[] {6}))))).satisfies(lines -> {
                    assertThat(lines.get(0)).endsWith("S3_ev3-color,battery_v,S3_ev3-color_1,S3_ev3-color_2");
                    assertThat(lines.get(1)).endsWith(",7,8.1,,");
                    assertThat(lines.get(2)).endsWith(",1,8.1,2,3");
                    assertThat(lines.get(3)).endsWith(",6,8.1,,");
                });
    }

    @Test
    void severalRobotsHaveTheirNamesBeforeTheirSignals() throws IOException {
        assertThat(lines(at(0, robot("left"), robot("right"))).get(0)).startsWith("time_s,left.x_m,")
                .contains(",left.battery_v,right.x_m,");
    }

    @Test
    void whatIsNotFiniteCanBeReadAsANumber() throws IOException {
        assertThat(
                lines(at(0, robot("r", new SensorSample(2, "x",
                        new double[] {Double.POSITIVE_INFINITY, Double.NaN, Double.NEGATIVE_INFINITY}))))
                .get(1)).endsWith(",inf,,-inf,8.1");
    }
}
