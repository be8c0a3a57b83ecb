package programs.students;

import lejos.hardware.Button;
import lejos.hardware.Sound;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.motor.EV3MediumRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3IRSensor;

/** Driven by the infrared remote control on channel 1; the beacon button ends it. */
public class RemoteCar {
    enum Command {
        NONE(0, 0), UP_LEFT(1, 0), DOWN_LEFT(-1, 0), UP_RIGHT(0, 1), DOWN_RIGHT(0, -1), BOTH_UP(1, 1), CROSS(1, -1),
        OTHER_CROSS(-1, 1), BOTH_DOWN(-1, -1);

        final int left, right;

        Command(int left, int right) {
            this.left = left;
            this.right = right;
        }
    }

    static final int BEACON = 9, LEFTS = 10, RIGHTS = 11;

    EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
    EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);
    EV3MediumRegulatedMotor head = new EV3MediumRegulatedMotor(MotorPort.A);
    EV3IRSensor ir = new EV3IRSensor(SensorPort.S1);

    void drive() {
        int last = -1;
        while (!Button.ESCAPE.isDown()) {
            int code = ir.getRemoteCommand(0);
            if (code == last) {
                Thread.yield();
                continue;
            }
            last = code;
            System.out.println("code " + code);
            if (code == BEACON) {
                break;
            } else if (code == LEFTS) {
                head.rotateTo(45, true);
            } else if (code == RIGHTS) {
                head.rotateTo(-45, true);
            } else {
                Command c = Command.values()[code];
                run(left, c.left);
                run(right, c.right);
            }
        }
        left.stop(true);
        right.stop(true);
        head.rotateTo(0);
        Sound.twoBeeps();
    }

    static void run(EV3LargeRegulatedMotor m, int direction) {
        if (direction > 0) {
            m.forward();
        } else if (direction < 0) {
            m.backward();
        } else {
            m.flt(true);
        }
    }

    public static void main(String[] args) {
        RemoteCar car = new RemoteCar();
        car.left.setSpeed(400);
        car.right.setSpeed(400);
        car.drive();
        System.exit(0);
    }
}
