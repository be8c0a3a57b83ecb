/**
 * Reads worlds and robots from SVG drawings; errors carry file, line and element id. Nothing is fetched from a network
 * and nothing outside the drawing's folder is opened. May use: {@code brickless.world}, {@code brickless.units}, the
 * JDK's StAX and ImageIO, JTS for polygon checks.
 *
 * <p>The way of a file: {@code SourceText} (bytes to text) → {@code SvgDocumentParser} (text to a tree of {@code
 * SvgElement}) → {@code DrawingWalker} (groups, {@code use}, transforms and styles resolved: a stream of {@code
 * DrawnShape}) → {@code WorldAssembler} or {@code RobotAssembler} (the meaning of {@code data-*} attributes).
 */
package brickless.world.svg;
