package brickless.world.svg;

import brickless.world.DescriptionException;
import brickless.world.RobotModel;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Reads a robot from an SVG drawing; the format is described in {@code sim/docs/WORLD-FORMAT.md}. No state; safe for
 * all threads.
 */
public final class SvgRobotReader {
    private SvgRobotReader() {}

    /**
     * Reads a robot file.
     *
     * @param file the drawing
     * @return the robot, named after the file
     * @throws DescriptionException if the file cannot be used; the message is one line that says where and why
     */
    public static RobotModel read(Path file) throws DescriptionException {
        String text = SourceText.read(file);
        return RobotAssembler.assemble(SvgDocumentParser.parse(file.toString(),
                Optional.ofNullable(file.toAbsolutePath().getParent()), text));
    }

    /**
     * Reads a robot from text.
     *
     * @param name name of the robot and for messages
     * @param svg the drawing
     * @return the robot
     * @throws DescriptionException if the drawing cannot be used; the message is one line that says where and why
     */
    public static RobotModel readText(String name, String svg) throws DescriptionException {
        return RobotAssembler.assemble(SvgDocumentParser.parse(name, Optional.empty(), svg));
    }
}
