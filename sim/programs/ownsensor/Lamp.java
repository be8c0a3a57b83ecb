import lejos.hardware.port.Port;
import lejos.hardware.sensor.AnalogSensor;
import lejos.hardware.sensor.SensorMode;

/** A driver for the NXT light sensor: pin 1 falls with the light; the type of the port switches the lamp. */
class Lamp extends AnalogSensor {
    Lamp(Port port) {
        super(port);
        setModes(new SensorMode[] {new Light("Bright", TYPE_LIGHT_ACTIVE), new Light("Dark", TYPE_LIGHT_INACTIVE)});
    }

    private class Light implements SensorMode {
        private final String name;
        private final int type;

        Light(String name, int type) {
            this.name = name;
            this.type = type;
        }

        @Override
        public int sampleSize() {
            return 1;
        }

        @Override
        public void fetchSample(float[] sample, int offset) {
            switchType(type, 10);
            sample[offset] = 1 - normalize(port.getPin1());
        }

        @Override
        public String getName() {
            return name;
        }
    }
}
