import lejos.hardware.port.Port;
import lejos.hardware.sensor.SensorMode;
import lejos.hardware.sensor.UARTSensor;

/** A driver for the EV3 ultrasonic sensor: whole millimetres, or tenths of an inch. */
class Sonar extends UARTSensor {
    Sonar(Port port) {
        super(port, 0);
        setModes(new SensorMode[] {new Distance("Millimetres", 0), new Distance("Inches", 1)});
    }

    private class Distance implements SensorMode {
        private final String name;
        private final int hardwareMode;

        Distance(String name, int hardwareMode) {
            this.name = name;
            this.hardwareMode = hardwareMode;
        }

        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchMode(hardwareMode, 50);
            sample[offset] = port.getShort();
        }

        @Override
        public String getName() {
            return name;
        }
    }
}
