package kit;

import lejos.hardware.motor.Motor;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3GyroSensor;
import lejos.utility.Delay;

/** A turn to the left on the spot, watched by the gyro. */
public final class Turning {
    private Turning() {}

    public static void main(String[] args) {
        EV3GyroSensor gyro = new EV3GyroSensor(SensorPort.S2);
        float[] sample = new float[2];
        Motor.B.rotate(-180, true);
        Motor.C.rotate(180, true);
        Delay.msDelay(300);
        gyro.getAngleAndRateMode().fetchSample(sample, 0);
        System.out.println("turning " + sample[0] + " " + sample[1]);
        Motor.B.waitComplete();
        Motor.C.waitComplete();
        Delay.msDelay(300);
        gyro.getAngleAndRateMode().fetchSample(sample, 0);
        System.out.println("turned " + sample[0] + " " + sample[1]);
    }
}
