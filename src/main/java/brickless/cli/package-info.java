/**
 * The command line program. Used by nobody. May use: {@code brickless.simulation} and below, {@code brickless.viewer},
 * picocli.
 */
package brickless.cli;
