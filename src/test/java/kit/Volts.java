package kit;

import lejos.hardware.Battery;
import lejos.hardware.motor.UnregulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.utility.Delay;

/** The battery at rest, under load, and after it was changed for an emptier one. */
public final class Volts {
    private Volts() {}

    public static void main(String[] args) {
        Delay.msDelay(100);
        print("rest");
        UnregulatedMotor left = new UnregulatedMotor(MotorPort.B);
        UnregulatedMotor right = new UnregulatedMotor(MotorPort.C);
        left.setPower(100);
        right.setPower(100);
        Delay.msDelay(20);
        print("load");
        left.flt();
        right.flt();
        Delay.msDelay(1000);
        print("recovered");
        Delay.msDelay(1500);
        print("emptier");
    }

    private static void print(String name) {
        System.out.println(name + " " + Battery.getVoltage() + " " + Battery.getVoltageMilliVolt() + " "
                + Battery.getBatteryCurrent() + " "
                + Battery.getMotorCurrent());
    }
}
