package brickless.simulation;

import brickless.device.RobotDevices;
import brickless.device.motor.MotorDevice;
import brickless.device.motor.MotorFitting;
import brickless.device.sensor.SensorFitting;
import brickless.device.sensor.SensorPortDevice;
import brickless.loading.hints.HardwareHints;
import brickless.world.MotorType;
import brickless.world.SensorType;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Plugs in what a program uses and its robot lacks: motors seen in its bytecode, and what it opens at run time. */
final class RunTimeFitting implements MotorFitting, SensorFitting {
    /**
     * The class of {@code Motor.A} to {@code Motor.D}: using one of them opens all four ports, so opening tells nothing
     * about the others.
     */
    static final String READY_MADE = "NXTRegulatedMotor";

    private final List<String> plugged = new ArrayList<>();
    private final Set<String> missing = new LinkedHashSet<>();

    /** Plugs in the motors that are used, before the program begins; {@code Motor.A} is only ever seen so. */
    void plugMotors(List<HardwareHints.Device> used, RobotDevices devices) {
        used.forEach(motor -> plug(devices.motor(motor.port().charAt(0) - 'A'), motor.lejosClass()));
    }

    @Override
    public void expected(MotorDevice device, String lejosClass) {
        if (!lejosClass.equals(READY_MADE)) {
            plug(device, lejosClass);
        }
    }

    private void plug(MotorDevice device, String lejosClass) {
        if (device.type() == null) {
            device.plug(lejosClass.contains("Medium") ? MotorType.MEDIUM : MotorType.LARGE);
            plugged.add(device.connected() + " on " + (char) ('A' + device.port()));
        }
    }

    @Override
    public void expected(SensorPortDevice device, String lejosClass) {
        HardwareHints.Device used = new HardwareHints.Device("S" + (device.port() + 1), lejosClass, "");
        Optional<SensorType> known = RobotFitter.sensorOf(lejosClass);
        if (known.isPresent() ? device.type() != known.get()
                : device.type() == null && RobotFitter.sensorOf(used).isPresent()) {
            device.plug(RobotFitter.mount(lejosClass, device.port()));
            plugged.add(device.connected() + " on " + used.port());
        } else if (device.type() == null) {
            missing.add("nothing is plugged into " + used.port() + ": there is no simulated sensor for the program's "
                    + lejosClass);
        }
    }

    /** What was plugged in, in order. */
    List<String> plugged() {
        return plugged;
    }

    /** A text for each sensor that could not be plugged in, because it is not simulated. */
    Set<String> missing() {
        return missing;
    }
}
