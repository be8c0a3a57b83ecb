/**
 * JUnit 5 support: simulations as test parameters, tests that run on the virtual brick, and expectations about the
 * course of a run. May use: {@code brickless.simulation}, {@code brickless.program}, {@code brickless.world} and
 * JUnit's API, which is an optional dependency: nothing else in Brickless refers to this package.
 */
package brickless.junit;
