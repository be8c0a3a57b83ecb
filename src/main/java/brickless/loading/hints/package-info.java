/**
 * Finds out, without running a program, which motors and sensors it expects at which ports, and the size of its wheels.
 * May use: ASM, the JDK.
 */
package brickless.loading.hints;
