package lejos.utility;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Properties;
import java.util.stream.Collectors;
import lejos.hardware.motor.Motor;
import lejos.robotics.RegulatedMotor;

/** The measures of a vehicle, kept in the file {@code pilot.props} of the working directory. */
public class PilotProps extends Properties {
    /** Name of the file. */
    public static final String PERSISTENT_FILENAME = "pilot.props";
    /** Key of the wheel diameter. */
    public static final String KEY_WHEELDIAMETER = "wheelDiameter";
    /** Key of the track width. */
    public static final String KEY_TRACKWIDTH = "trackWidth";
    /** Key of the left motor, {@code A} to {@code D}. */
    public static final String KEY_LEFTMOTOR = "leftMotor";
    /** Key of the right motor, {@code A} to {@code D}. */
    public static final String KEY_RIGHTMOTOR = "rightMotor";
    /** Key of whether the motors run in reverse. */
    public static final String KEY_REVERSE = "reverse";

    private static final long serialVersionUID = 1L;

    /** No values yet. */
    public PilotProps() {}

    /**
     * Reads the file; without one nothing changes.
     *
     * @throws IOException if the file cannot be read
     */
    public void loadPersistentValues() throws IOException {
        File file = new File(PERSISTENT_FILENAME);
        if (file.exists()) {
            try (InputStream in = new FileInputStream(file)) {
                load(in);
            }
        }
    }

    /**
     * Writes the file, sorted and without the date that {@link Properties} would add.
     *
     * @throws IOException if the file cannot be written
     */
    public void storePersistentValues() throws IOException {
        ByteArrayOutputStream lines = new ByteArrayOutputStream();
        store(lines, null);
        String undated = lines.toString(StandardCharsets.ISO_8859_1).lines()
                .filter(line -> !line.startsWith("#")).sorted().collect(Collectors.joining("\n", "", "\n"));
        try (OutputStream out = new FileOutputStream(PERSISTENT_FILENAME)) {
            out.write(undated.getBytes(StandardCharsets.ISO_8859_1));
        }
    }

    /** The motor of {@link Motor} by the letter of its port, null for anything else. */
    public static RegulatedMotor getMotor(String motor) {
        return switch (motor) {
            case "A" -> Motor.A;
            case "B" -> Motor.B;
            case "C" -> Motor.C;
            case "D" -> Motor.D;
            default -> null;
        };
    }
}
