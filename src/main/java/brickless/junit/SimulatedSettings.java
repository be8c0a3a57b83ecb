package brickless.junit;

import brickless.simulation.Library;
import brickless.simulation.SimulationSettings;
import brickless.simulation.StimuliReader;
import brickless.world.DescriptionException;
import brickless.world.RobotModel;
import brickless.world.World;
import brickless.world.svg.SvgRobotReader;
import brickless.world.svg.SvgWorldReader;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.ExtensionConfigurationException;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.platform.commons.support.AnnotationSupport;

/** What the {@link Simulated} annotations on a test's method and class say together; the method's comes first. */
final class SimulatedSettings {
    private static final int DEFAULT_SECONDS = 60;

    private final String test;
    private final List<Simulated> annotations;

    private SimulatedSettings(String test, List<Simulated> annotations) {
        this.test = test;
        this.annotations = annotations;
    }

    static SimulatedSettings of(ExtensionContext context) {
        Optional<Simulated> onMethod = AnnotationSupport.findAnnotation(context.getTestMethod(), Simulated.class);
        Optional<Simulated> onClass = AnnotationSupport.findAnnotation(context.getRequiredTestClass(), Simulated.class,
                context.getEnclosingTestClasses());
        return new SimulatedSettings(context.getRequiredTestClass().getSimpleName(), Stream.of(onMethod, onClass)
                .flatMap(Optional::stream).toList());
    }

    private <T> T first(Function<Simulated, T> value, Predicate<T> given, T otherwise) {
        return annotations.stream().map(value).filter(given).findFirst().orElse(otherwise);
    }

    private String text(Function<Simulated, String> value, String otherwise) {
        return first(value, text -> !text.isEmpty(), otherwise);
    }

    /** Class of the program for parameters of type {@code Run}. */
    Optional<Class<?>> program() {
        return Optional.<Class<?>>ofNullable(first(Simulated::program, type -> type != void.class, null));
    }

    /** The settings; {@code seed} replaces the annotation's. */
    SimulationSettings settings(Path out, OptionalLong seed) {
        String world = text(Simulated::world, "pen");
        try {
            SimulationSettings.Builder builder = SimulationSettings.builder(world(world)).worldFile(isDrawing(world)
                    ? "" : world)
                    .seed(seed.orElse(first(Simulated::seed, value -> value != Simulated.NO_SEED, 1L)))
                    .limit(limit())
                    .ideal(annotations.stream().anyMatch(Simulated::ideal)).pressButtons(pressButtons())
                    .stimuli(StimuliReader.readText("stimuli of " + test, String.join("\n", stimuli())))
                    .files(Optional.of(text(Simulated::files, "")).filter(name -> !name.isEmpty()).map(Path::of))
                    .out(Optional.of(out));
            String robot = text(Simulated::robot, "auto");
            if (!robot.equals("auto")) {
                builder.robot(robot(robot));
            }
            return builder.build();
        } catch (DescriptionException e) {
            throw new ExtensionConfigurationException(e.getMessage(), e);
        }
    }

    private Duration limit() {
        int seconds = first(Simulated::seconds, value -> value != 0, DEFAULT_SECONDS);
        if (seconds < 0) {
            throw new ExtensionConfigurationException("@Simulated: " + seconds + " seconds; a limit is above zero");
        }
        return Duration.ofSeconds(seconds);
    }

    private boolean pressButtons() {
        String buttons = text(Simulated::buttons, "auto");
        if (!List.of("auto", "none").contains(buttons)) {
            throw new ExtensionConfigurationException("@Simulated: '" + buttons
                    + "' is no button policy; allowed: auto, none");
        }
        return buttons.equals("auto");
    }

    private String[] stimuli() {
        return first(Simulated::stimuli, lines -> lines.length > 0, new String[0]);
    }

    private World world(String text) throws DescriptionException {
        return isDrawing(text) ? SvgWorldReader.readText("world of " + test, text.strip()) : new Library(Path.of(""))
                .world(text);
    }

    private RobotModel robot(String text) throws DescriptionException {
        return isDrawing(text) ? SvgRobotReader.readText("robot of " + test, text.strip()) : new Library(Path.of(""))
                .robot(text);
    }

    private static boolean isDrawing(String text) {
        return text.stripLeading().startsWith("<");
    }
}
