package brickless.cli;

import brickless.viewer.Speed;
import brickless.viewer.ViewOptions;
import java.util.Optional;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** Options of the live view. */
final class ViewFlags {
    @Option(names = "--port", paramLabel = "N", defaultValue = "0",
            description = "Port on this machine (default: any that is free).")
    private int port;

    @Option(names = "--token", paramLabel = "TEXT",
            description = "Secret part of the address, at least 16 characters (default: random). "
            + "With the same port and token an open page finds a restarted view again.")
    private String token;

    @Option(names = "--no-browser", description = "Only prints the address.")
    private boolean noBrowser;

    @Option(names = "--speed", paramLabel = "SPEED", defaultValue = "1", converter = SpeedConverter.class,
            description = "Simulated seconds per second: 0.1 to 100, or max (default: 1).")
    private double speed;

    /** Whether a browser is to be opened. */
    boolean browser() {
        return !noBrowser;
    }

    ViewOptions options() {
        try {
            return ViewOptions.of(port, Optional.ofNullable(token), speed);
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage());
        }
    }

    private static final class SpeedConverter implements ITypeConverter<Double> {
        @Override
        public Double convert(String value) {
            return Speed.parse(value).orElseThrow(() ->
                    new TypeConversionException("'" + value + "' is no speed; allowed: 0.1 to 100, max"));
        }
    }
}
