package brickless.simulation;

import brickless.loading.hints.HardwareHints;
import brickless.world.SensorType;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Guesses which sensor a driver of the program's own reads: by the name of the driver or of the variable that holds it,
 * else the most common one (assumption) among those that talk in this way.
 */
final class OwnDriver {
    /**
     * What a driver may be meant for.
     *
     * @param names names that tell
     * @param sensor the sensor
     */
    private record Guess(Pattern names, SensorType sensor) {
        static Guess of(String names, SensorType sensor) {
            return new Guess(Pattern.compile(names), sensor);
        }

        boolean fits(HardwareHints.Device device) {
            return Arrays.stream(device.name().split(" ")).anyMatch(name -> names.matcher(name).matches());
        }
    }

    private static final String COLOUR = "(?i).*(colou?r|farb|couleur).*";
    private static final String TOUCH = "(?i).*(touch|bump|button|switch|taster).*";

    /** By the leJOS class that a driver extends; the last guess is for any name. */
    private static final Map<String, List<Guess>> GUESSES = Map.of(
            "UARTSensor", List.of(Guess.of(COLOUR, SensorType.EV3_COLOR),
                    Guess.of("(?i).*(gyro|angle|heading|kreisel).*", SensorType.EV3_GYRO),
                    Guess.of("(?i).*(infra|beacon|proximity|remote).*|ir|.*(IR|_ir|Ir)", SensorType.EV3_INFRARED),
                    Guess.of(".*", SensorType.EV3_ULTRASONIC)),
            "I2CSensor", List.of(Guess.of(".*", SensorType.NXT_ULTRASONIC)),
            "AnalogSensor", List.of(Guess.of("(?i)ev3.*touch.*", SensorType.EV3_TOUCH),
                    Guess.of(TOUCH, SensorType.NXT_TOUCH),
                    Guess.of("(?i).*(sound|noise|mic|schall).*", SensorType.NXT_SOUND),
                    Guess.of(COLOUR, SensorType.NXT_COLOR),
                    Guess.of(".*", SensorType.NXT_LIGHT)));

    private OwnDriver() {}

    /** The sensor for a driver; empty if it extends nothing that tells. */
    static Optional<SensorType> sensorOf(HardwareHints.Device device) {
        return GUESSES.getOrDefault(device.lejosClass(), List.of()).stream().filter(guess -> guess.fits(device))
                .map(Guess::sensor).findFirst();
    }

    /** One line about what was guessed for the drivers of a program; empty if it has none. */
    static Optional<String> describe(HardwareHints hints) {
        List<String> guesses = hints.sensors().stream().filter(sensor -> GUESSES.containsKey(sensor.lejosClass()))
                .map(sensor -> sensorOf(sensor).orElseThrow().attribute() + " on " + sensor.port() + " for "
                        + driver(sensor)).toList();
        return guesses.isEmpty() ? Optional.empty()
                : Optional.of("guessed for drivers of its own: " + String.join(", ", guesses)
                        + " (--robot FILE plugs in something else)");
    }

    private static String driver(HardwareHints.Device sensor) {
        String name = sensor.name().split(" ")[0];
        return name.isEmpty() ? "a " + sensor.lejosClass() : name + " (" + sensor.lejosClass() + ")";
    }
}
