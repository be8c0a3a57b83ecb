package brickless.simulation;

import brickless.device.RobotDevices;
import brickless.hardware.BrickHardware;
import brickless.hardware.KeySocket;
import brickless.hardware.LedSocket;
import brickless.hardware.MotorSocket;
import brickless.hardware.MoveRequest;
import brickless.hardware.PowerSocket;
import brickless.hardware.ProgramLog;
import brickless.hardware.ScreenSocket;
import brickless.hardware.SensorSocket;
import brickless.hardware.SpeakerSocket;

/** The sockets of one robot's brick, put together. */
record VirtualBrick(String name, RobotDevices devices, Panel panel, ProgramLog log) implements BrickHardware {
    @Override
    public MotorSocket motor(int index) {
        return devices.motor(index);
    }

    @Override
    public SensorSocket sensor(int index) {
        return devices.sensor(index);
    }

    @Override
    public void moveTogether(int[] ports, MoveRequest[] requests) {
        devices.moveTogether(ports, requests);
    }

    @Override
    public ScreenSocket screen() {
        return panel.screen();
    }

    @Override
    public KeySocket keys() {
        return panel.keys();
    }

    @Override
    public LedSocket leds() {
        return panel.leds();
    }

    @Override
    public SpeakerSocket speaker() {
        return panel.speaker();
    }

    @Override
    public PowerSocket power() {
        return devices.battery();
    }
}
