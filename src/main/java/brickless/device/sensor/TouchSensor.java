package brickless.device.sensor;

import brickless.physics.Bumper;
import brickless.world.SensorType;

/** A button, pressed by what its outline hits or by a hand: the EV3's raises pin 6, the NXT's pulls pin 1 down. */
final class TouchSensor extends AnalogSensor {
    private static final int EV3_DEVICE = 16;
    private static final int NXT_DEVICE = 1;
    /** Pin 6 of a pressed EV3 button, volts. */
    private static final double EV3_PRESSED_VOLTS = 3.9;
    /** Pin 1 of an EV3 button: the resistor that identifies it, volts. */
    private static final double EV3_IDENTITY_VOLTS = 0.42;
    /** Pin 1 of a pressed NXT button, volts. */
    private static final double NXT_PRESSED_VOLTS = 0.9;

    private final boolean ev3;
    private final Bumper bumper;

    TouchSensor(SensorSite site) {
        super(site);
        ev3 = site.mount().type() == SensorType.EV3_TOUCH;
        bumper = site.robot().bumper(site.mount());
    }

    private boolean pressed() {
        return bumper.pressed() || site().pushed();
    }

    @Override
    int deviceType() {
        return ev3 ? EV3_DEVICE : NXT_DEVICE;
    }

    @Override
    double pin1Volts(long nowNanos) {
        return ev3 ? EV3_IDENTITY_VOLTS : pressed() ? NXT_PRESSED_VOLTS : PULL_UP_VOLTS;
    }

    @Override
    double pin6Volts(long nowNanos) {
        return ev3 && pressed() ? EV3_PRESSED_VOLTS : 0;
    }

    @Override
    double[] reading(long nowNanos) {
        return new double[] {pressed() ? 1 : 0};
    }
}
