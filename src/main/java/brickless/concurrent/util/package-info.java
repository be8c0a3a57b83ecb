/**
 * Synchronized collections and timers of {@code java.util} for programs in virtual time.
 *
 * <p>Vector, Hashtable and the wrappers of {@code Collections.synchronized…} are replaced although they never block by
 * themselves: programs hold <em>their</em> monitor ({@code synchronized (list) { … }}), which is virtual, so their
 * methods have to take the same one; and they call {@code equals}, {@code hashCode}, {@code toString} and callbacks of
 * the program with it held. StringBuffer calls back only for the text of one argument and stays the JDK's. {@code
 * java.util.Properties} stays, too, and so is not a {@link brickless.concurrent.util.Hashtable}.
 *
 * <p>May use: {@code brickless.concurrent.locks}, the JDK.
 */
package brickless.concurrent.util;
