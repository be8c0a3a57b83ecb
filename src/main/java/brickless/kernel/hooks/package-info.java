/**
 * What rewritten bytecode calls, and the interface through which it reaches the kernel; plain JDK behaviour until a
 * kernel is bound. May use: the JDK, and {@code brickless.files} for a brick's files.
 *
 * <p>Two kinds of classes. <b>Shared</b> ones, loaded once by the application: the boundary to the kernel
 * ({@code VirtualMachine}, {@code Budget}, {@code ProgramKilled}), constants and tables ({@code InstructionCharges},
 * {@code JdkCall}, {@code JdkCalls}) and stateless text ({@code FloatingText}, {@code ThrowableText}). All others are
 * <b>per robot</b>: the robot's class loader defines them anew, without rewriting. Robots with the same program share
 * that loader; what must be each robot's own is in its {@code RobotState}, static fields of other classes are caches of
 * what is the same for all. {@code …Hooks} are static methods that stand for JDK calls, {@code Program…} classes extend
 * the JDK class that programs construct, or stand for it everywhere. Which call goes where is data:
 * {@code jdk-calls.txt} here, {@code jdk-replacements.txt} in
 * {@code brickless.loading}.
 *
 * <p>Everything here runs on the running fibre; hooks never hold a JDK lock while they call the kernel.
 */
package brickless.kernel.hooks;
