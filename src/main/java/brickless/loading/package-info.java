/**
 * The robot's class loader: finds the program, leJOS and their helpers, decides by named rules who gets rewritten, and
 * rewrites bytecode so that every blocking call, loop and source of chance goes through {@code brickless.kernel.hooks}.
 * One rewriter, one concern, one file. May use: {@code brickless.kernel.hooks}, ASM, the JDK.
 */
package brickless.loading;
