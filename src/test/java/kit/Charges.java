package kit;

import lejos.hardware.Button;
import lejos.hardware.lcd.LCD;
import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;

/** What calls cost, in microseconds of the program's own clock. */
public final class Charges {
    private static final int TIMES = 200;
    private static int sink;

    private Charges() {}

    public static void main(String[] args) throws InterruptedException {
        EV3LargeRegulatedMotor motor = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3UltrasonicSensor sonar = new EV3UltrasonicSensor(SensorPort.S4);
        EV3TouchSensor touch = new EV3TouchSensor(SensorPort.S1);
        float[] sample = new float[1];
        Object lock = new Object();
        print("loop", () -> { });
        print("serialRead", () -> sonar.fetchSample(sample, 0));
        print("analogueRead", () -> touch.fetchSample(sample, 0));
        print("tacho", () -> sink += motor.getTachoCount());
        print("isMoving", () -> sink += motor.isMoving() ? 1 : 0);
        int[] turn = {0};
        print("command", () -> {
            turn[0]++;
            motor.rotateTo(turn[0] % 2, true);
        });
        print("println", () -> System.out.println("a line of text"));
        print("drawString", () -> LCD.drawString("seventeen columns", 0, 1));
        print("clock", () -> sink += (int) System.nanoTime());
        print("key", () -> sink += Button.getButtons());
        print("led", () -> Button.LEDPattern(1));
        print("refresh", LCD::refresh);
        print("monitor", () -> {
            synchronized (lock) {
                sink++;
            }
        });
        print("kilobyte", () -> sink += new byte[1000].length);
        print("yield", Thread::yield);
        long begin = System.nanoTime();
        Thread[] threads = new Thread[10];
        for (int i = 0; i < threads.length; i++) {
            threads[i] = new Thread(() -> { });
            threads[i].start();
        }
        System.out.println("cost.thread " + (System.nanoTime() - begin) / 1e3 / threads.length);
        for (Thread thread : threads) {
            thread.join();
        }
    }

    private static void print(String name, Runnable call) {
        long begin = System.nanoTime();
        for (int i = 0; i < TIMES; i++) {
            call.run();
        }
        long end = System.nanoTime();
        System.out.println("cost." + name + " " + (end - begin) / 1e3 / TIMES);
    }
}
