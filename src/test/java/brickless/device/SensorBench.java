package brickless.device;

import brickless.TestWorlds;
import brickless.device.sensor.SensorPortDevice;
import brickless.physics.ArenaSettings;
import brickless.world.Obstacle;
import brickless.world.Paint;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.Region;
import brickless.world.Rgb;
import brickless.world.RobotModel.SensorMount;
import brickless.world.SensorType;
import brickless.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A robot with one sensor on port S1. */
final class SensorBench {
    final RobotBench bench;
    final SensorPortDevice port;

    SensorBench(World world, SensorMount mount, boolean ideal) {
        this(world, mount, ideal, 1);
    }

    SensorBench(World world, SensorMount mount, boolean ideal, long seed) {
        bench = new RobotBench(world, TestWorlds.educator(mount), new Pose2(0, 0, 0), ArenaSettings.of(ideal), seed);
        port = bench.devices.sensor(0);
    }

    static SensorBench of(SensorType type, Obstacle... obstacles) {
        return new SensorBench(TestWorlds.with(obstacles), front(type, 0.06), true);
    }

    static SensorBench onPaint(SensorType type, Paint... paint) {
        return new SensorBench(TestWorlds.world(List.of(), List.of(paint)), front(type, 0.008), true);
    }

    /** A sensor 60 mm ahead of the axle that looks forward. */
    static SensorMount front(SensorType type, double height) {
        return new SensorMount("sensor", 0, type, new Point2(0.06, 0), 0, height, List.of(), Optional.empty());
    }

    static Paint paint(int rgb, double left, double top, double right, double bottom) {
        return new Paint("paint", new Region.Filled(List.of(TestWorlds.box(left, top, right, bottom)), false),
                new Rgb(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255), 1);
    }

    static Paint everywhere(int rgb) {
        return paint(rgb, -2, -2, 2, 2);
    }

    /** Reads numbers of the present mode off the serial line. */
    int[] shorts(int count) {
        byte[] bytes = new byte[2 * count];
        if (port.uart().read(bytes, 0, bytes.length) != bytes.length) {
            throw new IllegalStateException("short message");
        }
        int[] values = new int[count];
        for (int i = 0; i < count; i++) {
            values[i] = (short) (bytes[2 * i] & 0xff | bytes[2 * i + 1] << 8);
        }
        return values;
    }

    byte[] bytes(int count) {
        byte[] bytes = new byte[count];
        if (port.uart().read(bytes, 0, count) != count) {
            throw new IllegalStateException("short message");
        }
        return bytes;
    }

    List<Integer> repeated(int times, long everyMillis) {
        List<Integer> values = new ArrayList<>();
        for (int i = 0; i < times; i++) {
            values.add(shorts(1)[0]);
            bench.runMillis(everyMillis);
        }
        return values;
    }
}
