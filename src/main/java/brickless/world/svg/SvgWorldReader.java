package brickless.world.svg;

import brickless.world.DescriptionException;
import brickless.world.World;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Reads a world from an SVG drawing; the format is described in {@code sim/docs/WORLD-FORMAT.md}. No state; safe for
 * all threads.
 */
public final class SvgWorldReader {
    private SvgWorldReader() {}

    /**
     * Reads a world file.
     *
     * @param file the drawing; images beside it are read too
     * @return the world, named after the file
     * @throws DescriptionException if the file cannot be used; the message is one line that says where and why
     */
    public static World read(Path file) throws DescriptionException {
        String text = SourceText.read(file);
        return WorldAssembler.assemble(SvgDocumentParser.parse(file.toString(),
                Optional.ofNullable(file.toAbsolutePath().getParent()), text));
    }

    /**
     * Reads a world from text.
     *
     * @param name name of the world and for messages
     * @param svg the drawing; images must be embedded
     * @return the world
     * @throws DescriptionException if the drawing cannot be used; the message is one line that says where and why
     */
    public static World readText(String name, String svg) throws DescriptionException {
        return WorldAssembler.assemble(SvgDocumentParser.parse(name, Optional.empty(), svg));
    }
}
