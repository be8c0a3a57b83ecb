package programs.robots;

import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3IRSensor;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** Prints what the infrared remote sends on channel 2. */
public class RemoteWatch {
    public static void main(String[] args) {
        EV3IRSensor eye = new EV3IRSensor(SensorPort.S4);
        Stopwatch watch = new Stopwatch();
        int before = 0;
        while (watch.elapsed() < 5000) {
            int command = eye.getRemoteCommand(1);
            if (command != before) {
                System.out.println("command " + command);
            }
            before = command;
            Delay.msDelay(20);
        }
    }
}
