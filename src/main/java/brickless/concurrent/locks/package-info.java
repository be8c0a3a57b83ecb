/**
 * Locks of {@code java.util.concurrent.locks} for programs in virtual time, and the two classes on which every
 * replacement that blocks is built: {@link brickless.concurrent.locks.WaitingLine} (who is next) and {@link
 * brickless.concurrent.locks.Deadline} (for how long).
 *
 * <p>Only monitors of Java are used, so whatever makes monitors virtual makes these locks virtual. Stated contracts are
 * those of the public Java 17 documentation; unlike the originals the locks are not serializable. May use:
 * {@code brickless.kernel.hooks.OwnedLock}, the JDK.
 */
package brickless.concurrent.locks;
