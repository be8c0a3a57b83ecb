package brickless.simulation;

import brickless.device.RobotDevices;
import brickless.device.motor.MotorDevice;
import brickless.device.motor.MotorFitting;
import brickless.device.sensor.SensorFitting;
import brickless.device.sensor.SensorPortDevice;
import brickless.loading.hints.HardwareHints;
import brickless.world.MotorType;
import java.util.ArrayList;
import java.util.List;

/** Plugs in what a program uses and its robot lacks: motors seen in its bytecode, and what it opens at run time. */
final class RunTimeFitting implements MotorFitting, SensorFitting {
    /**
     * The class of {@code Motor.A} to {@code Motor.D}: using one of them opens all four ports, so opening tells nothing
     * about the others.
     */
    static final String READY_MADE = "NXTRegulatedMotor";

    private final List<String> plugged = new ArrayList<>();

    /** Plugs in the motors that are used, before the program begins; {@code Motor.A} is only ever seen so. */
    void plugMotors(List<HardwareHints.Device> used, RobotDevices devices) {
        used.forEach(motor -> plug(devices.motor(motor.port().charAt(0) - 'A'), motor.lejosClass()));
    }

    @Override public void expected(MotorDevice device, String lejosClass) {
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

    @Override public void expected(SensorPortDevice device, String lejosClass) {
        boolean fits = RobotFitter.sensorOf(lejosClass).map(type -> device.mount() != null && device.mount()
                .type() == type).orElse(true);
        if (!fits) {
            device.plug(RobotFitter.mount(lejosClass, device.port()));
            plugged.add(device.connected() + " on S" + (device.port() + 1));
        }
    }

    /** What was plugged in, in order. */
    List<String> plugged() {
        return plugged;
    }
}
