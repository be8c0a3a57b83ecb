/**
 * Programs that write and read files; each prints what it found. {@code brickless.simulation.ProgramFilesTest} runs
 * them.
 */
package programs.files;
