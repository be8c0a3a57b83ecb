/** Reads worlds and robots from SVG drawings; errors carry file, line and element id. May use: {@code brickless.world}, {@code brickless.units}. */
package brickless.world.svg;
