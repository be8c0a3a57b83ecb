/**
 * The live view: a run paced to the wall clock, watched and touched in a browser through a server on this machine.
 * Entry point, used by the command line only. May use: {@code brickless.simulation}, {@code brickless.program},
 * {@code brickless.trace}, {@code brickless.world}, the JDK's HTTP server.
 *
 * <p>Threads: one <em>driver</em> owns the run and everything about it ({@link brickless.viewer.Driver}); HTTP threads
 * hand it commands and write what it put into their viewer's {@link brickless.viewer.Mailbox}; a watch thread looks
 * after changed files.
 */
package brickless.viewer;
