package brickless.device.motor;

import brickless.TestWorlds;
import brickless.device.FakeProcessor;
import brickless.physics.Arena;
import brickless.physics.ArenaSettings;
import brickless.physics.Entrant;
import brickless.physics.Shaft;
import brickless.world.MotorType;
import brickless.world.Pose2;
import java.util.List;

/** One motor in a vice: its shaft can be loaded, blocked and observed, at a voltage of choice. */
final class MotorBench {
    final FakeProcessor processor;
    final MotorDevice motor;
    final Shaft shaft;
    double volts;

    MotorBench(MotorType type, double volts) {
        this(type, volts, ArenaSettings.DEFAULT_STEP_NANOS);
    }

    MotorBench(MotorType type, double volts, long stepNanos) {
        this.volts = volts;
        Arena arena = new Arena(TestWorlds.with(),
                List.of(new Entrant("bench", TestWorlds.robot(List.of(), List.of()), new Pose2(0, 0, 0))),
                new ArenaSettings(false, stepNanos));
        shaft = arena.robots().get(0).shaft(0);
        MotorDevice[] device = new MotorDevice[1];
        processor = new FakeProcessor(stepNanos, now -> {
            device[0].beforeStep(now, this.volts);
            arena.step();
        });
        motor = new MotorDevice(0, shaft, processor, arena, MotorFitting.FIXED);
        device[0] = motor;
        motor.plug(type);
    }

    /** Holds the shaft where it is. */
    void block() {
        shaft.setStops(shaft.angleRadians(), shaft.angleRadians());
    }

    double rpm() {
        return shaft.speedRadiansPerSecond() * 60 / (2 * Math.PI);
    }

    double degreesPerSecond() {
        return Math.toDegrees(shaft.speedRadiansPerSecond());
    }

    double seconds() {
        return processor.nowNanos() / 1e9;
    }
}
