/**
 * Programs that try one class of the kit each and print what they see, one {@code name value …} a line. They use leJOS
 * and the JDK only, so they could run on a brick.
 */
package kit;
