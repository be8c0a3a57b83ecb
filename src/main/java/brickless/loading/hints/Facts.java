package brickless.loading.hints;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What is known of a whole program: contents of fields, arguments, results, containers and objects, and the devices and
 * wheels found.
 */
final class Facts {
    private final Map<String, Clue> places = new LinkedHashMap<>();
    private final Map<String, HardwareHints.Device> devices = new TreeMap<>();
    private final Map<String, Axle> wheels = new LinkedHashMap<>();
    private final Map<String, Set<String>> names = new LinkedHashMap<>();
    private final Map<String, Double> numbers = new LinkedHashMap<>();
    private boolean argumentsArrived;
    private final SortedSet<String> reversed = new TreeSet<>();

    /** Adds knowledge about a field, argument, result or object. */
    void learn(String place, Clue clue) {
        if (clue != null && clue.known()) {
            places.merge(place, clue, Clue::or);
        }
    }

    /** Adds knowledge about what a method returns, once arguments had time to arrive: what it makes depends on them. */
    void returned(String method, Clue clue) {
        if (argumentsArrived) {
            learn(method, clue);
        }
    }

    /** Arguments have arrived where they are used. */
    void argumentsArrived() {
        argumentsArrived = true;
    }

    Clue at(String place) {
        return places.get(place);
    }

    /** Adds knowledge about what a container holds. */
    void put(Clue container, Clue key, Clue value) {
        if (isKey(key)) {
            learn(element(container, key), value);
        }
        learn(container.text() + "[]", value);
    }

    /**
     * What a container holds under a key, or anywhere if the key is not known or its value is not; null if nothing is
     * known.
     */
    Clue get(Clue container, Clue key) {
        Clue exact = isKey(key) ? places.get(element(container, key)) : null;
        return exact == null ? places.get(container.text() + "[]") : exact;
    }

    private static boolean isKey(Clue key) {
        return key.is(Clue.Kind.NUMBER) || key.is(Clue.Kind.TEXT) && key.ports().size() <= 1
                || key.is(Clue.Kind.OBJECT);
    }

    private static String element(Clue container, Clue key) {
        return container.text() + "[" + key.text() + key.number() + "]";
    }

    /** Notes that the device at a port is kept in a field or variable of this name. */
    void named(Clue device, String name) {
        if (device.is(Clue.Kind.DEVICE) && device.ports().size() == 1 && !name.isEmpty()) {
            names.computeIfAbsent(device.ports().first(), port -> new LinkedHashSet<>()).add(name);
        }
    }

    /** Notes that a field or variable of this name holds a number, the first time it does. */
    void number(String name, Clue value) {
        if (value.is(Clue.Kind.NUMBER) && value.number() > 0) {
            numbers.putIfAbsent(name, value.number());
        }
    }

    void device(String port, String lejosClass) {
        devices.merge(port, new HardwareHints.Device(port, lejosClass, ""), (old, found) -> old);
    }

    /** Notes a wheel; one at a known port counts more than one that may be at any of several. */
    void wheel(SortedSet<String> ports, Axle axle) {
        if (axle.isComplete() && ports.size() == 1) {
            wheels.put(ports.first(), axle);
        } else if (axle.isComplete()) {
            ports.forEach(port -> wheels.putIfAbsent(port, axle));
        }
    }

    /** Notes that motors are mounted the other way round. */
    void reversed(SortedSet<String> ports) {
        reversed.addAll(ports);
    }

    HardwareHints hints() {
        return new HardwareHints(devices(1), devices(2),
                wheels.entrySet().stream().filter(wheel -> !wheel.getValue().isOmni())
                .map(wheel -> ordinary(wheel.getKey(), wheel.getValue())).toList(), wheels.entrySet().stream().filter(
                wheel -> wheel.getValue().isOmni()).map(wheel -> omni(wheel.getKey(), wheel.getValue())).toList(),
                reversed, numbers);
    }

    private List<HardwareHints.Device> devices(int lengthOfPort) {
        return devices.values().stream().filter(device -> device.port().length() == lengthOfPort)
                .map(device -> new HardwareHints.Device(device.port(), device.lejosClass(), namesAt(device.port())))
                .toList();
    }

    private HardwareHints.Wheel ordinary(String port, Axle axle) {
        return new HardwareHints.Wheel(port, axle.diameter(), optional(axle.offset()), optional(axle.track()),
                axle.gear(), namesAt(port));
    }

    private static HardwareHints.OmniWheel omni(String port, Axle axle) {
        return new HardwareHints.OmniWheel(port, axle.diameter(), axle.place().x(), axle.place().y(),
                axle.place().headingDegrees(), axle.gear() > 0 ? 1 / axle.gear() : 1);
    }

    private static OptionalDouble optional(double value) {
        return Double.isNaN(value) ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    private String namesAt(String port) {
        return String.join(" ", names.getOrDefault(port, Set.of()));
    }
}
