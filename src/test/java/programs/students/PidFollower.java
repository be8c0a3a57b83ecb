package programs.students;

import lejos.hardware.BrickFinder;
import lejos.hardware.Button;
import lejos.hardware.ev3.EV3;
import lejos.hardware.lcd.TextLCD;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.sensor.EV3ColorSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.SampleProvider;
import lejos.robotics.filter.MeanFilter;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** A line follower with all three terms, for a quarter of a minute. */
public class PidFollower {
    static final double KP = 500, KI = 60, KD = 25;
    static final int SPEED = 220;
    static final int RUN_MS = 15000;

    private final RegulatedMotor leftMotor = new EV3LargeRegulatedMotor(MotorPort.B);
    private final RegulatedMotor rightMotor = new EV3LargeRegulatedMotor(MotorPort.C);
    private final EV3ColorSensor sensor;
    private final SampleProvider light;
    private final float[] sample;
    private final TextLCD lcd;

    PidFollower() {
        EV3 ev3 = (EV3) BrickFinder.getLocal();
        lcd = ev3.getTextLCD();
        sensor = new EV3ColorSensor(ev3.getPort("S3"));
        light = new MeanFilter(sensor.getMode("Red"), 3);
        sample = new float[light.sampleSize()];
    }

    float read() {
        light.fetchSample(sample, 0);
        return sample[0];
    }

    void follow(float target) {
        Stopwatch watch = new Stopwatch();
        double integral = 0;
        double lastError = 0;
        int lastTime = 0;
        int steps = 0;
        double worst = 0;
        while (watch.elapsed() < RUN_MS && Button.ESCAPE.isUp()) {
            int now = watch.elapsed();
            double dt = Math.max(1, now - lastTime) / 1000.0;
            double error = read() - target;
            integral = Math.max(-0.5, Math.min(0.5, integral + error * dt));
            double derivative = (error - lastError) / dt;
            int turn = (int) (KP * error + KI * integral + KD * derivative * 0.1);
            setMotor(leftMotor, SPEED + turn);
            setMotor(rightMotor, SPEED - turn);
            lastError = error;
            lastTime = now;
            if (steps++ > 100) {
                worst = Math.max(worst, Math.abs(error));
            }
            if (steps % 50 == 0) {
                lcd.drawString("error " + (int) (100 * error) + "   ", 0, 4);
            }
            Delay.msDelay(5);
        }
        leftMotor.stop(true);
        rightMotor.stop(false);
        System.out.println("steps " + steps);
        System.out.println("worst " + (int) (100 * worst));
    }

    void setMotor(RegulatedMotor motor, int speed) {
        motor.setSpeed(Math.abs(speed));
        if (speed >= 0) {
            motor.forward();
        } else {
            motor.backward();
        }
    }

    public static void main(String[] args) {
        PidFollower robot = new PidFollower();
        robot.lcd.drawString("Press to start", 0, 0);
        Button.waitForAnyPress();
        robot.lcd.clear();
        robot.follow(0.4f);
        robot.sensor.close();
        robot.leftMotor.close();
        robot.rightMotor.close();
    }
}
