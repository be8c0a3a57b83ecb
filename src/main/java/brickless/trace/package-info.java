/**
 * The record of a run: immutable samples and events, the canonical trace (JSON Lines) with its hash, and files made from it (CSV, SVG path).
 * May use: {@code brickless.world}, {@code brickless.units}, the JDK, Jackson's streaming writer.
 */
package brickless.trace;
