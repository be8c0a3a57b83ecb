package brickless.simulation;

import brickless.device.motor.MotorDevice;
import brickless.device.motor.MotorFitting;
import brickless.device.sensor.SensorFitting;
import brickless.device.sensor.SensorPortDevice;
import brickless.world.MotorType;
import java.util.ArrayList;
import java.util.List;

/**
 * Notes what a program opens on a drawn robot that is not plugged in there: leJOS notices neither a missing motor nor a
 * missing analogue sensor. Used by the running fibre only.
 */
final class PlugNotes implements MotorFitting, SensorFitting {
    private final List<String> notes = new ArrayList<>();

    @Override
    public void expected(MotorDevice device, String lejosClass) {
        char port = (char) ('A' + device.port());
        if (device.type() == null && !lejosClass.equals(RunTimeFitting.READY_MADE)) {
            note("no motor is plugged into " + port + ", so the program's " + lejosClass + " there never turns");
        } else if (device.type() != null && lejosClass.startsWith("EV3")
                && lejosClass.contains("Medium") != (device.type() == MotorType.MEDIUM)) {
            note(port + " has " + device.connected() + " plugged in; the program uses it as " + lejosClass);
        }
    }

    @Override
    public void expected(SensorPortDevice device, String lejosClass) {
        boolean fits = RobotFitter.sensorOf(lejosClass).map(type -> type == device.type()).orElse(true);
        if (!fits) {
            String found = device.type() == null ? "nothing is" : device.connected() + " is";
            note(found + " plugged into S" + (device.port() + 1) + "; the program uses " + lejosClass + " there");
        }
    }

    private void note(String text) {
        if (!notes.contains(text)) {
            notes.add(text);
        }
    }

    /** What was noticed, in order. */
    List<String> notes() {
        return notes;
    }
}
