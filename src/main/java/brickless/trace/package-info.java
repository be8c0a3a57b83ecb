/**
 * The record of a run: immutable samples and events, the canonical trace (JSON Lines) with its hash, its reader,
 * and files made from it (CSV, SVG path, HTML report).
 * May use: {@code brickless.world}, {@code brickless.units}, the JDK, Jackson's streaming reader and writer.
 */
package brickless.trace;
