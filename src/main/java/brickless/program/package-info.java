/**
 * Finds the leJOS program a user names (class, source file, directory, jar), compiles it where needed, and finds its
 * main class. May use: {@code brickless.loading}, the JDK.
 */
package brickless.program;
