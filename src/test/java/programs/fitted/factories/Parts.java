package programs.fitted.factories;

import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.Port;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.robotics.RegulatedMotor;

/** Makes the parts of the robot. */
final class Parts {
    static final String LEFT = "D";
    static final String RIGHT = "B";

    private Parts() {}

    static RegulatedMotor wheel(String port) {
        return new EV3LargeRegulatedMotor(port(port));
    }

    static RegulatedMotor arm() {
        return new EV3MediumRegulatedMotor(port("C"));
    }

    static EV3TouchSensor touch() {
        return new EV3TouchSensor(port("S1"));
    }

    private static Port port(String name) {
        return LocalEV3.get().getPort(name);
    }
}
