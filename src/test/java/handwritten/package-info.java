/**
 * Program fragments for tests of the kernel, as rewriting would leave them; outside {@code brickless}, so that dumps
 * show their lines.
 */
package handwritten;
