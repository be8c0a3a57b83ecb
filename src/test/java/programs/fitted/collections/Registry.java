package programs.fitted.collections;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.navigation.MovePilot;

/** Motors in a map, wheels in a list. */
public class Registry {
    private final Map<String, RegulatedMotor> motors = new HashMap<>();

    public static void main(String[] args) {
        Registry registry = new Registry();
        registry.motors.put("left", new EV3LargeRegulatedMotor(LocalEV3.get().getPort("C")));
        registry.motors.put("right", new EV3LargeRegulatedMotor(LocalEV3.get().getPort("B")));
        registry.run();
    }

    private void run() {
        List<Wheel> wheels = new ArrayList<>();
        wheels.add(WheeledChassis.modelWheel(motors.get("left"), 6.24).offset(-6.4));
        wheels.add(WheeledChassis.modelWheel(motors.get("right"), 6.24).offset(6.4));
        MovePilot pilot = new MovePilot(
                new WheeledChassis(wheels.toArray(new Wheel[0]), WheeledChassis.TYPE_DIFFERENTIAL));
        pilot.setLinearSpeed(15);
        pilot.setAngularSpeed(60);
        pilot.travel(45);
        pilot.rotate(180);
        pilot.travel(45);
        for (RegulatedMotor motor : motors.values()) {
            motor.close();
        }
    }
}
