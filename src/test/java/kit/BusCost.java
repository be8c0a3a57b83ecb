package kit;

import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.I2CSensor;

/** What a transaction on the bus costs, in microseconds. */
public final class BusCost {
    private BusCost() {}

    public static void main(String[] args) {
        I2CSensor sensor = new I2CSensor(SensorPort.S4);
        byte[] registers = new byte[8];
        long begin = System.nanoTime();
        for (int i = 0; i < 10; i++) {
            sensor.getData(0, registers, registers.length);
        }
        System.out.println("cost.transaction " + (System.nanoTime() - begin) / 1e3 / 10);
    }
}
