/**
 * Composition root and public Java API: puts a world, robots, a program and a kernel together, runs them step by step,
 * and reports the outcome. May use: everything except {@code brickless.junit}, {@code brickless.viewer} and
 * {@code brickless.cli}.
 */
package brickless.simulation;
