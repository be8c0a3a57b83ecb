/**
 * Streams of {@code java.io} for programs in virtual time: print streams, which would hold a JDK lock while they write
 * to a stream of the program, and pipes, which block. May use: {@code brickless.concurrent.locks}, the JDK.
 */
package brickless.concurrent.io;
