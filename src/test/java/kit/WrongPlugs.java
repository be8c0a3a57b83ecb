package kit;

import java.util.function.Supplier;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.motor.Motor;
import lejos.hardware.motor.UnregulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3GyroSensor;
import lejos.hardware.sensor.EV3IRSensor;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.hardware.sensor.NXTUltrasonicSensor;

/** Opens ports in ways that fail, and prints what it is told. */
public final class WrongPlugs {
    private WrongPlugs() {}

    public static void main(String[] args) {
        print("wrongSensor", () -> new EV3UltrasonicSensor(SensorPort.S1));
        print("afterwards", () -> new EV3TouchSensor(SensorPort.S1));
        print("taken", () -> new EV3GyroSensor(SensorPort.S1));
        print("motorPort", () -> new EV3IRSensor(MotorPort.A));
        print("sensorPort", () -> new EV3LargeRegulatedMotor(SensorPort.S1));
        print("bus", () -> new NXTUltrasonicSensor(SensorPort.S2));
        print("busAgain", () -> new NXTUltrasonicSensor(SensorPort.S2));
        print("first", () -> new UnregulatedMotor(MotorPort.D));
        print("ready", () -> Motor.A);
    }

    private static void print(String name, Supplier<Object> attempt) {
        try {
            System.out.println(name + " " + attempt.get().getClass().getSimpleName());
        } catch (RuntimeException | ExceptionInInitializerError e) {
            StringBuilder text = new StringBuilder();
            for (Throwable each = e; each != null; each = each.getCause()) {
                text.append(' ').append(each.getClass().getSimpleName()).append(": ").append(each.getMessage());
            }
            System.out.println(name + text);
        }
    }
}
