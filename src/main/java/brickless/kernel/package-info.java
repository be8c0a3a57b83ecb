/**
 * Virtual time: clock, event queue, fibres, monitors, scheduling, deadlock and runaway detection; and the real time
 * of live mode.
 *
 * <p>{@link brickless.kernel.Kernel} runs one program, {@link brickless.kernel.Ensemble} several that share a world;
 * both are explained in {@code sim/docs/CONCURRENCY.md} and {@code KERNEL.md}. May use: {@code brickless.kernel.hooks},
 * the JDK.
 */
package brickless.kernel;
