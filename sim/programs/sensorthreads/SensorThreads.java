package sensorthreads;

import lejos.hardware.motor.EV3LargeRegulatedMotor;
import lejos.hardware.port.MotorPort;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3TouchSensor;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;

/** One thread per sensor, shared through volatile fields and a monitor; the main thread drives. */
public class SensorThreads {
    private static volatile float metres = Float.POSITIVE_INFINITY;
    private static final Object bumped = new Object();
    private static int bumps;

    public static void main(String[] args) throws InterruptedException {
        EV3LargeRegulatedMotor left = new EV3LargeRegulatedMotor(MotorPort.B);
        EV3LargeRegulatedMotor right = new EV3LargeRegulatedMotor(MotorPort.C);

        Thread ear = new Thread("ear") {
            @Override
            public void run() {
                SampleProvider distance = new EV3UltrasonicSensor(SensorPort.S4).getDistanceMode();
                float[] sample = new float[1];
                while (!isInterrupted()) {
                    distance.fetchSample(sample, 0);
                    metres = sample[0];
                    try {
                        Thread.sleep(20);
                    } catch (InterruptedException e) {
                        interrupt();
                    }
                }
            }
        };
        Thread skin = new Thread(new Runnable() {
            @Override
            public void run() {
                SampleProvider touch = new EV3TouchSensor(SensorPort.S1).getTouchMode();
                float[] sample = new float[1];
                boolean before = false;
                while (true) {
                    touch.fetchSample(sample, 0);
                    boolean now = sample[0] > 0.5f;
                    if (now && !before) {
                        synchronized (bumped) {
                            bumps++;
                            bumped.notifyAll();
                        }
                    }
                    before = now;
                    Thread.yield();
                }
            }
        }, "skin");
        skin.setDaemon(true);
        ear.start();
        skin.start();

        left.setSpeed(360);
        right.setSpeed(360);
        for (int leg = 0; leg < 4; leg++) {
            left.forward();
            right.forward();
            waitForWall();
            left.setSpeed(180);
            right.setSpeed(180);
            left.rotate(-180, true);
            right.rotate(-180);
            left.rotate(190, true);
            right.rotate(-190);
            left.setSpeed(360);
            right.setSpeed(360);
        }
        left.stop(true);
        right.stop();
        ear.interrupt();
        ear.join();
        System.out.println("legs 4");
    }

    /** Waits until the wall is near or was hit. */
    private static void waitForWall() throws InterruptedException {
        synchronized (bumped) {
            int before = bumps;
            while (bumps == before && metres > 0.25f) {
                bumped.wait(50);
            }
        }
    }
}
