package brickless.loading.hints;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;

/** What is known of a whole program: contents of fields, arguments, results and constructed objects, and the devices and wheels found. */
final class Facts {
    private final Map<String, Clue> places = new LinkedHashMap<>();
    private final Map<String, HardwareHints.Device> devices = new TreeMap<>();
    private final Map<String, HardwareHints.Wheel> wheels = new LinkedHashMap<>();
    private final Map<String, String> names = new LinkedHashMap<>();

    /** Adds knowledge about a field, argument, result or object. */
    void learn(String place, Clue clue) {
        if (clue != null && clue.known()) {
            places.merge(place, clue, Clue::or);
        }
    }

    Clue at(String place) {
        return places.get(place);
    }

    /** Notes that the device at a port is kept in a field or variable of this name. */
    void named(Clue device, String name) {
        if (device.kind() == Clue.Kind.DEVICE && device.ports().size() == 1 && !name.isEmpty()) {
            names.putIfAbsent(device.ports().first(), name);
        }
    }

    void device(String port, String lejosClass) {
        devices.merge(port, new HardwareHints.Device(port, lejosClass, ""), (old, found) -> old);
    }

    void wheel(String port, Clue.Axle axle) {
        wheels.put(port, new HardwareHints.Wheel(port, axle.diameter(), optional(axle.offset()), optional(axle.track()), axle.gear(), ""));
    }

    private static java.util.OptionalDouble optional(double value) {
        return Double.isNaN(value) ? java.util.OptionalDouble.empty() : java.util.OptionalDouble.of(value);
    }

    HardwareHints hints() {
        return new HardwareHints(
                devices.values().stream().filter(d -> d.port().length() == 1).map(this::withName).toList(),
                devices.values().stream().filter(d -> d.port().length() == 2).map(this::withName).toList(),
                wheels.values().stream().map(w -> new HardwareHints.Wheel(w.port(), w.diameter(), w.offset(), w.trackWidth(), w.gearRatio(),
                        names.getOrDefault(w.port(), ""))).toList());
    }

    private HardwareHints.Device withName(HardwareHints.Device device) {
        return new HardwareHints.Device(device.port(), device.lejosClass(), names.getOrDefault(device.port(), ""));
    }
}
