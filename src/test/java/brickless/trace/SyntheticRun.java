package brickless.trace;

import brickless.trace.RobotSample.MotorSample;
import brickless.trace.RobotSample.SensorSample;
import brickless.world.MotorType;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.RobotModel;
import brickless.world.World;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;

/** Runs made up for tests: what a busy program leaves behind, without simulating it. */
final class SyntheticRun {
    static final String ROBOT = "robot";
    private static final long SAMPLE_NANOS = 50_000_000;

    private final Random random = new Random(42);
    private final TraceListener listener;
    private final double[] signals = new double[24];

    SyntheticRun(TraceListener listener) {
        this.listener = listener;
        listener.header(new TraceHeader("demo.Busy", "hall", List.of("made-up"), 3, -1, false, 2_000_000,
                SAMPLE_NANOS));
    }

    /** Every signal moves with noise; the program prints, draws and arbitrates all the time. */
    static void busy(TraceListener listener, int seconds) {
        SyntheticRun run = new SyntheticRun(listener);
        run.at(0, new TraceEvent.ArbitratorEvent(0, List.of("demo.Cruise", "demo.Turn")));
        for (int i = 0; i <= seconds * 20; i++) {
            long time = i * SAMPLE_NANOS;
            listener.sample(run.noisySample(time));
            if (i % 5 == 0) {
                run.at(time, run.noisyScreen());
                run.at(time, new TraceEvent.BehaviourEvent("active", 0, i / 5 % 2));
            }
            if (i % 2 == 0) {
                run.at(time, new TraceEvent.PrintEvent("distance " + run.random.nextInt(2550) + " mm, light "
                        + run.random.nextInt(100), false));
            }
        }
        run.at(seconds * 1_000_000_000L, new TraceEvent.EndEvent("time-limit", -1));
    }

    /** One sample at the origin. */
    void standing(long timeNanos) {
        listener.sample(new Sample(timeNanos, List.of(robot(new Pose2(0, 0, 0))), List.of()));
    }

    void at(long timeNanos, TraceEvent event) {
        listener.event(timeNanos, ROBOT, event);
    }

    private static RobotSample robot(Pose2 pose) {
        return new RobotSample(ROBOT, pose, List.of(), List.of(), 8);
    }

    private Sample noisySample(long time) {
        for (int i = 0; i < signals.length; i++) {
            signals[i] += random.nextGaussian() * (i % 5 + 1);
        }
        List<MotorSample> motors = new ArrayList<>();
        List<SensorSample> sensors = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            motors.add(new MotorSample((char) ('A' + i), signals[i] * 10, signals[i + 4], signals[i + 8],
                    signals[i + 12]));
            sensors.add(new SensorSample(i + 1, "ev3-ultrasonic", new double[] {signals[i + 16]}));
        }
        Pose2 pose = new Pose2(signals[20] / 100, signals[21] / 100, signals[22]);
        return new Sample(time, List.of(new RobotSample(ROBOT, pose, motors, sensors, 8 + signals[23] / 100)),
                List.of(new BodySample("crate", new Pose2(signals[20] / 50, signals[21] / 50, signals[22]))));
    }

    private TraceEvent noisyScreen() {
        List<Integer> rows = new ArrayList<>();
        List<String> pixels = new ArrayList<>();
        for (int row = 16; row < 48; row++) {
            byte[] bytes = new byte[23];
            random.nextBytes(bytes);
            rows.add(row);
            pixels.add(HexFormat.of().formatHex(bytes));
        }
        return new TraceEvent.ScreenEvent(rows, pixels);
    }

    /** An empty hall of 2 m by 1 m with this drawing. */
    static ReportScene scene(String worldSvg) {
        World world = new World("hall", 0, 0, 2, 1, List.of(), List.of(), List.of(), List.of(), List.of(),
                Optional.empty(), List.of(), worldSvg);
        List<Point2> outline = List.of(new Point2(-0.1, -0.05), new Point2(0.1, -0.05), new Point2(0.1, 0.05),
                new Point2(-0.1, 0.05));
        RobotModel.Wheel wheel = new RobotModel.Wheel("left", 1, MotorType.LARGE, 0.056, 1, false,
                new Point2(0, -0.06), 0, false);
        RobotModel robot = new RobotModel("made-up", List.of(outline), 0.7, List.of(wheel), List.of(), List.of(),
                List.of(), List.of(), "");
        return new ReportScene(world, Map.of(ROBOT, robot));
    }

    /** The hall with nothing but its floor. */
    static ReportScene scene() {
        return scene("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 2000 1000\">"
                + "<rect width=\"2000\" height=\"1000\" fill=\"#eeeeee\"/></svg>");
    }
}
