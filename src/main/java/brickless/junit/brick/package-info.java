/**
 * The part of the JUnit support that lives inside a robot: defined per robot and rewritten like a program, so that what
 * it calls runs in virtual time. May use: the JDK and JUnit's API.
 */
package brickless.junit.brick;
