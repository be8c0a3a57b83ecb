/**
 * Behaviour-based control: independent behaviours in order of priority, and an arbitrator that lets one of them drive.
 *
 * <p>Plain Java: runs in any JVM. May use: the JDK, slf4j-api, {@code brickless.hardware} to report to a brick that is
 * there.
 */
package lejos.robotics.subsumption;
