package brickless.bench;

import brickless.device.FakeProcessor;
import brickless.device.RobotDevices;
import brickless.device.motor.MotorFitting;
import brickless.device.sensor.FloorColour;
import brickless.device.sensor.SensorFitting;
import brickless.device.sensor.Surroundings;
import brickless.physics.Arena;
import brickless.physics.ArenaSettings;
import brickless.physics.RobotBody;
import brickless.world.World;
import java.util.ArrayList;
import java.util.List;

/** Physics and devices without programs: every robot drives in circles and measures distances. */
final class DrivingRobots extends StepCost {
    private static final int LEFT_DUTY = 40;
    private static final int RIGHT_DUTY = 25;

    DrivingRobots(int robots) {
        super(robots);
    }

    @Override
    Stepper stepper() {
        RobotGrid grid = new RobotGrid(robots());
        World world = grid.world();
        Arena arena = new Arena(world, grid.entrants(), ArenaSettings.of(false));
        Surroundings surroundings = new Surroundings(arena, FloorColour.of(world), 1, false);
        List<RobotDevices> robots = new ArrayList<>();
        for (RobotBody body : arena.robots()) {
            robots.add(driving(new RobotDevices(body, surroundings,
                    new FakeProcessor(ArenaSettings.DEFAULT_STEP_NANOS, time -> { }),
                    MotorFitting.FIXED, SensorFitting.FIXED)));
        }
        return time -> {
            for (int i = 0; i < robots.size(); i++) {
                robots.get(i).beforeStep(time);
            }
            arena.step();
            for (int i = 0; i < robots.size(); i++) {
                robots.get(i).afterStep(time);
            }
        };
    }

    private static RobotDevices driving(RobotDevices devices) {
        devices.sensor(3).uart().initialise(0);
        devices.motor(1).drive(LEFT_DUTY);
        devices.motor(2).drive(RIGHT_DUTY);
        return devices;
    }
}
