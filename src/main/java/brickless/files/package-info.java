/**
 * The files of a robot's brick: a small file system in memory, one per robot and run, for {@code java.io} and {@code
 * java.nio.file} alike. What a program writes stays here until the run hands it out; nothing of the host shows.
 *
 * <p>Uses the JDK only. Used by one program thread at a time, or by whoever drives a run that is held.
 */
package brickless.files;
