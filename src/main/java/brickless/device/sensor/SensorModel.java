package brickless.device.sensor;

import brickless.hardware.SensorSocket.Wiring;
import brickless.physics.Aim;
import brickless.world.SensorType;
import java.util.Optional;

/**
 * A device plugged into an input port. Values are computed when asked for, from the arena's state after the last step.
 *
 * <p>A new device is one class that extends {@link AnalogSensor}, {@link UartSensor} or {@link RegisterSensor}, named
 * in {@link SensorType} and in {@link #of}.
 */
abstract class SensorModel {
    private final SensorSite site;

    SensorModel(SensorSite site) {
        this.site = site;
    }

    /** Creates the model of a mounted sensor. */
    static SensorModel of(SensorSite site) {
        return switch (site.mount().type()) {
            case EV3_TOUCH, NXT_TOUCH -> new TouchSensor(site);
            case EV3_COLOR -> new ColourSensor(site);
            case EV3_ULTRASONIC -> new UltrasonicSensor(site);
            case EV3_GYRO -> new GyroSensor(site);
            case EV3_INFRARED -> new InfraredSensor(site);
            case NXT_LIGHT -> new NxtLightSensor(site);
            case NXT_SOUND -> new NxtSoundSensor(site);
            case NXT_COLOR -> new NxtColourSensor(site);
            case NXT_ULTRASONIC -> new NxtUltrasonicSensor(site);
        };
    }

    final SensorSite site() {
        return site;
    }

    final Aim aim() {
        return site.aim();
    }

    final SensorType type() {
        return site.mount().type();
    }

    abstract Wiring wiring();

    /** LEGO's number of the device. */
    abstract int deviceType();

    /**
     * What it sends in its present mode, in the device's own units, for traces; empty while it sends nothing. Changes
     * nothing.
     */
    abstract double[] reading(long nowNanos);

    /** What a distance sensor reached last; changes nothing. */
    Optional<SensorBeam> beam() {
        return Optional.empty();
    }

    /** What a sensor that looks down looks at; changes nothing. */
    Optional<SensorSpot> spot() {
        return Optional.empty();
    }

    /** LEGO's name of the present mode, for traces; empty for devices without modes and while it sends nothing. */
    String modeName() {
        return "";
    }

    /** Back to the state after power-on. */
    void powerOff() {
        // Most devices have no state.
    }
}
