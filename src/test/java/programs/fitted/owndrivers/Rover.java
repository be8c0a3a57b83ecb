package programs.fitted.owndrivers;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;

/** Drivers of its own for an I2C and a serial distance sensor and a switch; stops before the wall. */
public class Rover {
    public static void main(String[] args) {
        EV3LargeRegulatedMotor l = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor r = new EV3LargeRegulatedMotor(MotorPort.C);
        RangeRegisters range = new RangeRegisters(SensorPort.S1);
        SerialSonar sonar = new SerialSonar(SensorPort.S4);
        Switch front = new Switch(SensorPort.S2);
        l.setSpeed(300);
        r.setSpeed(300);
        l.forward();
        r.forward();
        while (sonar.millimetres() > 300 && !front.closed()) {
            Thread.yield();
        }
        l.stop(true);
        r.stop();
        System.out.println(Math.abs(range.centimetres() - sonar.millimetres() / 10) <= 3 ? "agreed" : "differ");
    }
}
